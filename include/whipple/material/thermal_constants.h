// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>

/// Constants that models of temperature, strength and failure share, described once.
namespace whipple::common_constants
{
  inline const ModelConstant reference_temperature{
      "Reference temperature", "temperature", "of the reference state: e = 0 at gamma0",
      Range::not_negative(),   300.,          false};
  inline const ModelConstant specific_heat{
      "Specific heat", "specific heat", "at constant volume, of the solid", Range::positive(), {}, false};
  inline const ModelConstant volume_correction{"Grueneisen volume correction",
                                               "pure number",
                                               "a of Steinberg and Guinan's melting law: how Gamma0 falls with density",
                                               Range::not_negative(),
                                               1.5,
                                               false};
} // namespace whipple::common_constants
