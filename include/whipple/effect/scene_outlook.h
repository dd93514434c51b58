// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/effect/effect_verdict.h>
#include <whipple/material/material.h>

#include <array>
#include <string>
#include <vector>

/// What `Effects/List = auto` decides by: numbers of the scene alone, before it runs (doc/theory/effects_auto.md).
namespace whipple
{
  /// What the worst encounter of two bodies does to the materials, by one-dimensional impact.
  struct Encounter
  {
    std::string description;  ///< "sphere on bumper at 6.58 km/s"
    double      pressure = 0; ///< behind the shocks of first contact, Mbar
    double      residual = 0; ///< energy left after release to zero pressure, as a part of the melt onset's
    double      vapour   = 0; ///< the same as a part of the onset of boiling
    double kinetic = 0;  ///< kinetic energy of what is thrown out of its course, as a part of the melt onset's: what
                         ///< plastic flow can turn into heat
    double stress   = 0; ///< pressure / yield stress, of the material where that is least
    double tension  = 0; ///< tension of a free reflection / spall strength, of the material where that is largest
    double duration = 0; ///< that the pressure lasts in the thinner body, us
    std::array<double, 2> echo{}; ///< time in which a wave crosses the body and comes back, over its length, us/cm
    bool is_known  = true;        ///< false: no such wave solution; everything the scene has a model for is kept
    bool of_solids = true;        ///< false: a gas is one of them
  };

  /// A material as the scene calls it, with all models that the scene names, whatever is on.
  struct NamedMaterial
  {
    std::string name;
    Material    model;
  };

  /// A scene as those see it that judge whether they matter in it.
  struct SceneOutlook
  {
    std::vector<NamedMaterial> materials;
    std::vector<Encounter>     encounter;         ///< highest pressure first
    double                     joined_duration;   ///< us in which cells share faces
    double                     finest_cell;       ///< cm
    int                        bodies_alike;      ///< most bodies of one material
    bool                       flies_as_elements; ///< material goes on to a moving mesh

    /// Whether there are impacts, and all have a wave solution.
    bool
    is_known() const;

    /// Of all encounters; 0 and infinity if there is none.
    double
    largest(double Encounter::*number) const;
    double
    least(double Encounter::*number) const;

    /// Whether a material names a model of this kind: `any_has(&Material::strength)`.
    template <class Model>
    bool
    any_has(std::shared_ptr<const Model> Material::*model) const
    {
      for (const NamedMaterial &material : materials)
        if (material.model.*model)
          return true;
      return false;
    }

    /// Whether a material enters with pores.
    bool
    is_porous() const;
  };

  /// What is to be said where no material names a model under `key`, or where no impact can be judged by.
  EffectVerdict
  off_without_model(const std::string &key);
  EffectVerdict
  kept_unknown();

  /// A number as verdicts and encounters show it: three digits.
  std::string
  rounded(double value);
} // namespace whipple
