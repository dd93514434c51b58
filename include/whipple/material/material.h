// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/conduction_law.h>
#include <whipple/material/equation_of_state.h>
#include <whipple/material/failure_model.h>
#include <whipple/material/fragment_model.h>
#include <whipple/material/strength.h>
#include <whipple/material/thermal_model.h>
#include <whipple/material/void_law.h>

#include <memory>
#include <string>

namespace whipple
{
  /// One material of a scene: its models, ready to run. Models that the scene leaves out are null.
  struct Material
  {
    std::string                            name;   ///< "aluminium 2024-T4"
    std::string                            source; ///< where the constants come from
    std::shared_ptr<const EquationOfState> eos;
    std::shared_ptr<const ThermalModel>    thermal;    ///< null: no temperature
    std::shared_ptr<const Strength>        strength;   ///< null: hydrodynamic
    std::shared_ptr<const VoidLaw>         void_law;   ///< null: phi = 0 always, no field allocated
    std::shared_ptr<const FailureModel>    failure;    ///< null: no damage
    std::shared_ptr<const FragmentModel>   fragments;  ///< null: no fragment sizes
    std::shared_ptr<const ConductionLaw>   conduction; ///< null: adiabatic
    bool isothermal = false; ///< eos is an IsothermalEquationOfState: P_s(gamma, 0) as in 1993; work is still booked
    /// Bulk density of a cell, g/cm^3, up to which what it holds of this material has no state of its own
    /// (doc/theory/traces.md).
    double trace_density = 0;
    bool   melts         = false; ///< voids open without a threshold where it is molten (thermal is there)
  };
} // namespace whipple
