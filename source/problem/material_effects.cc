// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>
#include <whipple/error.h>
#include <whipple/material/material_factory.h>
#include <whipple/problem/material_effects.h>

#include <algorithm>
#include <stdexcept>

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
      const auto &all   = model_families();
      const auto  found = std::find_if(all.begin(), all.end(), [&](const ModelFamily &f) { return f.key == key; });
      if (found == all.end())
        throw std::logic_error("an effect needs models of a family '" + key + "', which there is not");
      return *found;
    }

    bool
    any_has(const std::vector<SceneMaterial> &materials, const ModelFamily &family)
    {
      return std::any_of(materials.begin(), materials.end(), [&](const SceneMaterial &material) {
        return chosen_model(family, material.request) != nullptr;
      });
    }
  } // namespace

  void
  check_effects(const std::vector<SceneMaterial> &materials, const std::vector<MaterialModels> &models,
                const std::vector<std::string> &effects)
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
    const auto                 is_on = [&](const std::string &name) { return contains(effects, name); };
    std::vector<NamedMaterial> complete;
    for (std::size_t m = 0; m < models.size(); ++m)
      complete.push_back({materials[m].name, models[m].complete});
    for (const EffectDescription &effect : effect_descriptions())
      if (effect.check)
        effect.check(complete, is_on);
  }

  double
  initial_void_fraction(const Material &material)
  {
    return material.void_law ? material.void_law->initial_void_fraction() : 0.;
  }

  Material
  with_effects(const Material &complete, const std::vector<std::string> &effects)
  {
    Material                             material = complete;
    const std::vector<EffectDescription> all      = effect_descriptions();
    for (const EffectDescription &effect : all)
      if (effect.leave_out && !contains(effects, effect.name))
        effect.leave_out(material);
    for (const EffectDescription &effect : all)
      if (effect.take_up && contains(effects, effect.name))
        effect.take_up(material);
    return material;
  }
} // namespace whipple::sections
