// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/scene.h>

#include <array>
#include <string>
#include <vector>

/// Which effects matter, from the scene alone (`Effects/List = auto`). The numbers and what is made of them:
/// doc/theory/effects_auto.md.
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

  /// All pairs of bodies of which one moves towards the other, highest pressure first; empty if no two bodies meet. An
  /// impact of the same two states at the same speed is solved once.
  template <int dim>
  std::vector<Encounter>
  encounters(const Scene<dim> &scene);

  /// Of the pairs of bodies in the same two states only the slowest and the fastest: every number of an encounter rises
  /// with the speed, so that no verdict needs the others. However many bodies, as many impacts as pairs of states.
  template <int dim>
  std::vector<Encounter>
  extreme_encounters(const Scene<dim> &scene);

  /// Time spent in stages whose cells are joined (all but Lagrangian ones of fragments), us: stages that wait for the
  /// leading edge count the way at the speed of the fastest body.
  template <int dim>
  double
  joined_duration(const Scene<dim> &scene);

  /// For every effect there is: number, verdict and reason. Needs materials (complete), bodies, stages and lattice.
  template <int dim>
  std::vector<EffectVerdict>
  forecast_effects(const Scene<dim> &scene);

  /// A number as verdicts and encounters show it: three digits.
  std::string
  rounded(double value);

  /// A verdict as a row of a table to read, without line end.
  std::string
  effect_line(const EffectVerdict &verdict);
} // namespace whipple
