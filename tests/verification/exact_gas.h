// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/riemann.h>
#include <whipple/exact/sedov.h>
#include <whipple/material/ideal_gas.h>

namespace whipple::verification
{
  /// Sod's shock tube with the diaphragm at 0.
  inline exact::Riemann
  sod()
  {
    const auto gas = std::make_shared<IdealGas>(1.4, 1.);
    return {{gas, 1., 0., 2.5}, {gas, 0.125, 0., 2.}};
  }

  /// The point explosion of prm/verification/sedov.prm in all of space: exponent 5/3, shock at 1 cm at 1 us.
  inline exact::Sedov
  sedov_sphere()
  {
    return exact::Sedov({3, 5. / 3., 1., 0.4935932});
  }
} // namespace whipple::verification
