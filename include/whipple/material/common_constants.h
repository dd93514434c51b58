// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>

/// Constants that several models share, described once. Their keys are those of the library.
namespace whipple::common_constants
{
  inline const ModelConstant density{"Density",         "density", "gamma0, at zero pressure and energy",
                                     Range::positive(), {},        false};
  inline const ModelConstant sound_speed{"Sound speed",     "velocity", "c0 of U_s = c0 + s u",
                                         Range::positive(), {},         false};
  inline const ModelConstant hugoniot_slope{
      "Hugoniot slope", "pure number", "s of U_s = c0 + s u", Range::not_negative(), {}, false};
  inline const ModelConstant grueneisen{
      "Grueneisen coefficient", "pure number", "Gamma0 at gamma0", Range::positive(), {}, false};
  inline const ModelConstant adiabatic_exponent{
      "Adiabatic exponent", "pure number", "gamma of a gas", Range::above(1.), {}, false};
  inline const ModelConstant shear_modulus{"Shear modulus", "pressure", "G of the solid", Range::positive(), {}, false};
  inline const ModelConstant yield_stress{"Yield stress",        "pressure", "Y in simple tension, unworked",
                                          Range::not_negative(), {},         false};
} // namespace whipple::common_constants
