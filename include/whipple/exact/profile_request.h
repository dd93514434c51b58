// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>

/// What the makers of profile solutions read from a scene; each throws InputError (one line, without file name) where
/// the scene is not what the solution needs.
namespace whipple::exact
{
  /// An ideal gas as it enters the scene.
  struct IdealGasState
  {
    double exponent = 0; ///< ratio of specific heats
    double density  = 0; ///< g/cm^3
    double energy   = 0; ///< Mbar cm^3/g
  };

  /// Dimensions of space in which the flow diverges: 1 planar, 2 cylindrical, 3 spherical.
  /// @throws InputError for a spherical profile in a scene of planar symmetry.
  int
  space_dimensions(const ExactRequest<2> &request);

  /// The one body of the scene, which must be an ideal gas.
  IdealGasState
  only_gas(const ExactRequest<2> &request);

  /// A constant of the request.
  double
  constant(const ExactRequest<2> &request, const std::string &key);

  /// The constants "KEY along axis 0" and "KEY along axis 1".
  Vector<2>
  vector_constant(const ExactRequest<2> &request, const std::string &key);

  /// A constant that must be > 0.
  double
  positive_constant(const ExactRequest<2> &request, const std::string &key);

  /// How far the profile coordinate reaches inside the first body in every direction, cm.
  double
  extent(const ExactRequest<2> &request);

  /// The profile laid into the plane of computation as the request says.
  std::unique_ptr<const ExactSolution<2>>
  in_plane(const ExactRequest<2> &request, std::unique_ptr<const Profile> profile);
} // namespace whipple::exact
