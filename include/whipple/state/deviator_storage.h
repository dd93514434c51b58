// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>

namespace whipple
{
  /// How the state holds the deviatoric stress of the solid: as one field for each independent component.
  template <int dim>
  struct DeviatorStorage;

  /// In a plane three: s_00, s_11, s_01 (rr, zz, rz); the one out of the plane (hoop) is -(s_00 + s_11), and none
  /// couples it to the others.
  template <>
  struct DeviatorStorage<2>
  {
    static constexpr int size = 3;

    /// Names of the fields.
    static constexpr std::array<const char *, size> field{
        {"deviatoric stress 00", "deviatoric stress 11", "deviatoric stress 01"}};

    /// The components that change sign in the mirror image at a plane normal to an axis.
    static constexpr std::array<int, 1>
    odd_at([[maybe_unused]] int axis)
    {
      return {{2}};
    }
  };
} // namespace whipple
