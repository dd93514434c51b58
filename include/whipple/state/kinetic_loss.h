// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace whipple
{
  /// What becomes of kinetic energy that averaging velocities loses.
  enum class KineticLoss
  {
    heat, ///< given to the internal energy of the cell that lost it, by mass
    drop  ///< only booked (the choice of 1993)
  };
} // namespace whipple
