// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/error.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/softened_strength.h>
#include <whipple/scene/material_effects.h>

#include <algorithm>

namespace whipple::sections
{
  namespace
  {
    bool
    contains(const std::vector<std::string> &effects, const std::string &name)
    {
      return std::find(effects.begin(), effects.end(), name) != effects.end();
    }

    const ModelFamily &
    family_of(const std::string &key)
    {
      const auto &all = model_families();
      return *std::find_if(all.begin(), all.end(), [&](const ModelFamily &f) { return f.key == key; });
    }

    bool
    any_has(const std::vector<SceneMaterial> &materials, const ModelFamily &family)
    {
      return std::any_of(materials.begin(), materials.end(), [&](const SceneMaterial &material) {
        return chosen_model(family, material.request) != nullptr;
      });
    }

    /// Without these the failure model of a material that is on would have nothing to go by.
    void
    check_failure(const SceneMaterial &material, const std::vector<std::string> &effects)
    {
      if (!material.complete.failure)
        return;
      if (material.complete.failure->needs_strength() && !contains(effects, "strength"))
        throw InputError("'failure' of material '" + material.name + "' ('" + material.complete.failure->name() +
                         "') goes by plastic strain: add the effect 'strength', or choose another failure model");
    }
  } // namespace

  void
  check_effects(const std::vector<SceneMaterial> &materials, const std::vector<std::string> &effects)
  {
    for (const EffectDescription &effect : effect_descriptions())
      {
        if (!contains(effects, effect.name))
          continue;
        for (const std::string &other : effect.requires_on)
          if (!contains(effects, other))
            throw InputError("'" + effect.name + "' means nothing without '" + other + "': add it, or leave '" +
                             effect.name + "' out");
        if (!effect.family.empty() && !any_has(materials, family_of(effect.family)))
          throw InputError("'" + effect.name + "' needs a material with a model for it; set Materials/NAME/" +
                           effect.family);
      }
    if (!contains(effects, "voids"))
      for (const SceneMaterial &material : materials)
        if (initial_void_fraction(material.complete) > 0.)
          throw InputError("material '" + material.name + "' is porous ('" + material.complete.void_law->name() +
                           "'): add the effect 'voids', or choose another void law");
    if (contains(effects, "failure"))
      for (const SceneMaterial &material : materials)
        check_failure(material, effects);
  }

  double
  initial_void_fraction(const Material &material)
  {
    return material.void_law ? material.void_law->initial_void_fraction() : 0.;
  }

  Material
  with_effects(const Material &complete, const std::vector<std::string> &effects)
  {
    Material material = complete;
    if (!contains(effects, "strength"))
      material.strength = nullptr;
    if (!contains(effects, "voids"))
      material.void_law = nullptr;
    if (!contains(effects, "failure"))
      material.failure = nullptr;
    if (!contains(effects, "fragment size"))
      material.fragments = nullptr;
    if (!contains(effects, "heat conduction"))
      material.conduction = nullptr;
    if (contains(effects, "melting") && material.thermal)
      {
        material.melts = true;
        if (material.strength && !material.strength->softens())
          material.strength = std::make_shared<SoftenedStrength>(material.strength, material.thermal);
      }
    return material;
  }
} // namespace whipple::sections
