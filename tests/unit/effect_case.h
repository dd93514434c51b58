// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/effect/effect.h>

#include <memory>
#include <string>
#include <vector>

/// The pass of one effect alone, on one rank, as a cycle makes and calls it.
namespace whipple::effect_case
{
  /// What an effect declares as defaults.
  inline EffectParameters
  default_parameters(const std::string &effect)
  {
    EffectParameters values;
    for (const ModelConstant &parameter : EffectRegistry<2>::find(effect)->description.parameters)
      values[parameter.key] = parameter.default_value.value();
    return values;
  }

  class LonePass
  {
  public:
    /// mesh, materials and fields are kept by reference.
    LonePass(const std::string &effect, const FlatMesh<2> &mesh, const std::vector<Material> &materials,
             const std::vector<FieldDescription> &fields)
      : LonePass(effect, mesh, materials, fields, default_parameters(effect))
    {
    }
    LonePass(const std::string &effect, const FlatMesh<2> &mesh, const std::vector<Material> &materials,
             const std::vector<FieldDescription> &fields, const EffectParameters &parameters)
      : passes_(make_passes<2>({effect}, mesh, materials, fields, {{effect, parameters}}))
    {
    }

    void
    advance(State<2> &state, const Derived &derived, const StepWork<2> &before, double dt)
    {
      passes_.pass.at(0)->advance({state, derived, before, dt, MeetingHalo<2>(halo_, [] {}), passes_.books});
    }

    const EffectPass<2> &
    pass() const
    {
      return *passes_.pass.at(0);
    }

    const EffectBooks<2> &
    books() const
    {
      return passes_.books;
    }

  private:
    Halo<2>         halo_;
    EffectPasses<2> passes_;
  };
} // namespace whipple::effect_case
