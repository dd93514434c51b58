// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>

/// Constants that failure models share, described once.
namespace whipple::common_constants
{
  inline const ModelConstant failure_void_fraction{
      "Failure void fraction",
      "pure number",
      "phi beyond which material counts as broken; above the initial porosity of porous material",
      Range::fraction(),
      1e-3,
      false};
} // namespace whipple::common_constants
