// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>
#include <whipple/material/model_input.h>
#include <whipple/registry.h>

#include <functional>
#include <memory>
#include <string>
#include <type_traits>

namespace whipple
{
  /// A model as scenes know it.
  template <class Family>
  struct ModelKind
  {
    ModelDescription                                                 description;
    std::function<std::shared_ptr<const Family>(const ModelInput &)> make;
    bool gives_temperature; ///< the model is a ThermalModel besides
  };

  /// All models of one family (equations of state, strengths ...), by name.
  template <class Family>
  class ModelRegistry : public Registry<ModelRegistry<Family>, ModelKind<Family>>
  {
  };

  /// Makes a model known under its name:
  ///
  ///     const Registration<Strength> registration(description, [](const ModelInput &c) { return ...; });
  template <class Family>
  class Registration
  {
  public:
    template <class Make>
    Registration(const ModelDescription &description, Make make)
      : registered_(description.name, {description, std::move(make), std::is_base_of_v<ThermalModel, ModelOf<Make>>})
    {
    }

  private:
    template <class Make>
    using ModelOf = typename std::invoke_result_t<Make, const ModelInput &>::element_type;

    typename ModelRegistry<Family>::Registered registered_;
  };
} // namespace whipple
