// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/equation_of_state_temperature.h>
#include <whipple/material/model_registry.h>

namespace whipple
{
  std::shared_ptr<const ThermalModel>
  equation_of_state_temperature(const std::shared_ptr<const EquationOfState> &eos)
  {
    if (auto thermal = std::dynamic_pointer_cast<const ThermalModel>(eos); thermal && thermal->has_temperature())
      return thermal;
    std::string able;
    for (const auto &[name, entry] : ModelRegistry<EquationOfState>::all())
      if (entry.gives_temperature)
        able += (able.empty() ? "'" : ", '") + name + "'";
    throw InputError("thermal model = 'equation of state': '" + (eos ? eos->name() : "none") +
                     "' gives no temperature; the equations of state that do: " + (able.empty() ? "none" : able));
  }

  namespace
  {
    ModelDescription
    description()
    {
      return {.name          = "equation of state",
              .summary       = "temperature and phases as the equation of state itself has them",
              .documentation = "For equations of state that are made of a free energy or a table over the temperature: "
                               "pressure, temperature, melting and boiling then agree with each other. Others need "
                               "'constant specific heat'.",
              .constants     = {},
              .source        = "that of the equation of state",
              .published     = {}};
    }

    const Registration<ThermalModel> registration(description(), [](const ModelInput &c) {
      return equation_of_state_temperature(c.equation_of_state);
    });
  } // namespace
} // namespace whipple
