// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_solution.h>

#include <memory>

namespace whipple::exact
{
  /// How a profile lies in the plane of computation.
  enum class Geometry
  {
    planar,      ///< along axis 1
    cylindrical, ///< distance from the axis (axisymmetric), from the origin (planar symmetry)
    spherical    ///< distance from the origin of (r, z)
  };

  /// State of a flow that depends on one coordinate and the time; entries not given are not_given.
  struct ProfileState
  {
    double density  = not_given; ///< g/cm^3
    double velocity = not_given; ///< along the coordinate, cm/us
    double pressure = not_given; ///< Mbar
    double energy   = not_given; ///< Mbar cm^3/g
  };

  /// An exact solution in one coordinate; the time is that of the solution itself, whose start need not be 0.
  class Profile
  {
  public:
    virtual ~Profile() = default;

    virtual ProfileState
    at(double coordinate, double time) const = 0;

    /// See ExactSolution.
    virtual bool
    counts(double, double) const
    {
      return true;
    }
    virtual std::vector<double>
    breaks(double) const
    {
      return {};
    }
    virtual std::optional<double>
    shock_position(double) const
    {
      return std::nullopt;
    }
  };

  /// A profile in the plane of computation.
  template <int dim>
  class ProfileSolution : public ExactSolution<dim>
  {
  public:
    /// @param start time of the profile when the run begins, us
    ProfileSolution(std::string name, std::unique_ptr<const Profile> profile, Geometry geometry, Symmetry symmetry,
                    double start);

    PointState<dim>
    at(const Vector<dim> &x, double time) const override;
    bool
    counts(const Vector<dim> &x, double time) const override;
    std::optional<double>
    profile_coordinate(const Vector<dim> &x) const override;
    std::vector<double>
    breaks(double time) const override;
    std::optional<double>
    shock_position(double time) const override;

  private:
    std::unique_ptr<const Profile> profile_;
    Geometry                       geometry_;
    Symmetry                       symmetry_;
    double                         start_;
  };
} // namespace whipple::exact
