// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>

namespace whipple
{
  /// Index into the flat arrays of one rank. Signed and 32 bits wide: what hardware gathers take.
  using Index = std::int32_t;

  /// "There is no such cell, face or node."
  inline constexpr Index none = -1;

  /// A point or vector; axis 0 is x or r, axis 1 is y or z.
  template <int dim>
  using Vector = std::array<double, dim>;

  /// The axis along which things fly: plates are normal to it, debris flies towards larger values on it, and where
  /// there is an axis of symmetry this is it.
  template <int dim>
  inline constexpr int flight_axis = dim - 1;

  /// What the plane of computation stands for.
  enum class Symmetry
  {
    planar,      ///< unit depth of 1 cm
    axisymmetric ///< axis 0 is the radius; volumes are true volumes of revolution (2 pi included)
  };
} // namespace whipple
