// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/exact/profile.h>

#include <cmath>
#include <utility>

namespace whipple::exact
{
  template <int dim>
  ProfileSolution<dim>::ProfileSolution(std::string name, std::unique_ptr<const Profile> profile, Geometry geometry,
                                        Symmetry symmetry, double start)
    : ExactSolution<dim>(std::move(name))
    , profile_(std::move(profile))
    , geometry_(geometry)
    , symmetry_(symmetry)
    , start_(start)
  {
  }

  template <int dim>
  std::optional<double>
  ProfileSolution<dim>::profile_coordinate(const Vector<dim> &x) const
  {
    if (geometry_ == Geometry::planar)
      return x[1];
    if (geometry_ == Geometry::cylindrical && symmetry_ == Symmetry::axisymmetric)
      return x[0];
    return std::hypot(x[0], x[1]);
  }

  template <int dim>
  PointState<dim>
  ProfileSolution<dim>::at(const Vector<dim> &x, double time) const
  {
    const double       distance = *profile_coordinate(x);
    const ProfileState state    = profile_->at(distance, start_ + time);
    PointState<dim>    result;
    result.density  = state.density;
    result.pressure = state.pressure;
    result.energy   = state.energy;
    if (geometry_ == Geometry::planar)
      result.velocity = {{0., state.velocity}};
    else if (geometry_ == Geometry::cylindrical && symmetry_ == Symmetry::axisymmetric)
      result.velocity = {{state.velocity, 0.}};
    else
      for (int d = 0; d < dim; ++d)
        result.velocity[d] = distance > 0 ? state.velocity * x[d] / distance : 0.;
    return result;
  }

  template <int dim>
  bool
  ProfileSolution<dim>::counts(const Vector<dim> &x, double time) const
  {
    return profile_->counts(*profile_coordinate(x), start_ + time);
  }

  template <int dim>
  std::vector<double>
  ProfileSolution<dim>::breaks(double time) const
  {
    return profile_->breaks(start_ + time);
  }

  template <int dim>
  std::optional<double>
  ProfileSolution<dim>::shock_position(double time) const
  {
    return profile_->shock_position(start_ + time);
  }

  template class ProfileSolution<2>;
} // namespace whipple::exact
