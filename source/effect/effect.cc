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
  double
  EffectSetup<dim>::parameter(const std::string &key) const
  {
    const auto found = parameters.find(key);
    if (found == parameters.end())
      throw std::logic_error("the effect has no parameter '" + key + "'");
    return found->second;
  }

  template <int dim>
  EffectPasses<dim>
  make_passes(const std::vector<std::string> &on, const FlatMesh<dim> &mesh, const std::vector<Material> &materials,
              const std::vector<FieldDescription> &fields, const std::map<std::string, EffectParameters> &parameters)
  {
    EffectPasses<dim>               passes;
    std::vector<BookingDescription> causes;
    for (const auto &[key, entry] : EffectRegistry<dim>::all())
      if (std::find(on.begin(), on.end(), key.second) != on.end())
        {
          const auto own = parameters.find(key.second);
          passes.pass.push_back(
              entry.make({mesh, materials, fields, own == parameters.end() ? EffectParameters() : own->second}));
          causes.insert(causes.end(), entry.description.bookings.begin(), entry.description.bookings.end());
        }
    passes.books = EffectBooks<dim>(causes);
    return passes;
  }

  std::vector<EffectDescription>
  effect_descriptions()
  {
    std::vector<EffectDescription> all;
    for (const auto &[name, option] : StepOptionRegistry::all())
      all.push_back(option);
    for (const auto &[key, entry] : EffectRegistry<2>::all())
      all.push_back(entry.description);
    std::sort(all.begin(), all.end(),
              [](const EffectDescription &a, const EffectDescription &b) { return a.name < b.name; });
    return all;
  }

  template struct EffectSetup<2>;
  template EffectPasses<2>
  make_passes(const std::vector<std::string> &, const FlatMesh<2> &, const std::vector<Material> &,
              const std::vector<FieldDescription> &, const std::map<std::string, EffectParameters> &);
} // namespace whipple
