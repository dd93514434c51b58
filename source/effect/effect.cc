// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect.h>

#include <algorithm>
#include <stdexcept>

namespace whipple
{
  int
  field_index(const std::vector<FieldDescription> &fields, const std::string &name)
  {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const FieldDescription &field) { return field.name == name; });
    return found == fields.end() ? -1 : static_cast<int>(found - fields.begin());
  }

  template <int dim>
  int
  EffectSetup<dim>::field(const std::string &name) const
  {
    const int found = field_index(fields, name);
    if (found < 0)
      throw std::logic_error("no effect that is on registered the field '" + name + "'");
    return found;
  }

  template <int dim>
  std::vector<std::unique_ptr<EffectPass<dim>>>
  make_passes(const std::vector<std::string> &effects, const EffectSetup<dim> &setup)
  {
    std::vector<std::unique_ptr<EffectPass<dim>>> passes;
    for (const auto &[name, entry] : EffectRegistry<dim>::all())
      if (entry.make && std::find(effects.begin(), effects.end(), name) != effects.end())
        passes.push_back(entry.make(setup));
    return passes;
  }

  std::vector<EffectDescription>
  effect_descriptions()
  {
    std::vector<EffectDescription> all;
    for (const auto &[name, entry] : EffectRegistry<2>::all())
      all.push_back(entry.description);
    return all;
  }

  template struct EffectSetup<2>;
  template std::vector<std::unique_ptr<EffectPass<2>>>
  make_passes(const std::vector<std::string> &, const EffectSetup<2> &);
} // namespace whipple
