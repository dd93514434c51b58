// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>
#include <whipple/material/model_input.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <type_traits>

namespace whipple
{
  /// All models of one family (equations of state, strengths ...), by name. Filled before main() by the one line
  ///
  ///     const Registration<Strength> registration(description, [](const ModelInput &c) { return ...; });
  ///
  /// at the end of each model's own file; never changed afterwards.
  template <class Family>
  class ModelRegistry
  {
  public:
    using Make = std::function<std::shared_ptr<const Family>(const ModelInput &)>;
    struct Entry
    {
      ModelDescription description;
      Make             make;
      bool             gives_temperature; ///< the model is a ThermalModel besides
    };

    /// All models there are, in alphabetical order.
    static const std::map<std::string, Entry> &
    all()
    {
      return entries();
    }

  private:
    template <class>
    friend class Registration;

    static std::map<std::string, Entry> &
    entries()
    {
      static std::map<std::string, Entry> registry;
      return registry;
    }
  };

  /// Makes a model known under its name.
  template <class Family>
  class Registration
  {
  public:
    template <class Make>
    Registration(ModelDescription description, Make make)
    {
      using Model            = typename std::invoke_result_t<Make, const ModelInput &>::element_type;
      const std::string name = description.name;
      ModelRegistry<Family>::entries().emplace(
          name, typename ModelRegistry<Family>::Entry{std::move(description), std::move(make),
                                                      std::is_base_of_v<ThermalModel, Model>});
    }
  };
} // namespace whipple
