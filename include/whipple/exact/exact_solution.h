// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace whipple::exact
{
  /// "The exact solution does not say."
  inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

  /// What an exact solution says of one point; entries it does not give are not_given.
  template <int dim>
  struct PointState
  {
    double      density  = not_given;             ///< g/cm^3
    double      pressure = not_given;             ///< Mbar, mean stress (positive in compression)
    double      energy   = not_given;             ///< specific internal energy, Mbar cm^3/g
    Vector<dim> velocity{{not_given, not_given}}; ///< cm/us
  };

  /// An exact solution of a scene: initial state, and what the run's fields are measured against.
  /// Immutable; evaluations are fast (tables are built in constructors) and may happen on any rank.
  template <int dim>
  class ExactSolution
  {
  public:
    explicit ExactSolution(std::string name)
      : name_(std::move(name))
    {
    }
    virtual ~ExactSolution() = default;

    /// Name in scene files, "noh".
    const std::string &
    name() const
    {
      return name_;
    }

    /// State at a point and a time since the start of the run.
    virtual PointState<dim>
    at(const Vector<dim> &x, double time) const = 0;

    /// Whether the errors of a cell around this point count: false where the run does not represent the solution
    /// (material that the boundaries of the domain have spoilt).
    virtual bool
    counts(const Vector<dim> &, double) const
    {
      return true;
    }

    /// Distance along which the solution is a profile (axis 1, radius ...), of a point, cm; none if it is no profile.
    virtual std::optional<double>
    profile_coordinate(const Vector<dim> &) const
    {
      return std::nullopt;
    }

    /// Profile coordinates of discontinuities (shocks, contacts, fronts) at a time, ascending, cm.
    virtual std::vector<double>
    breaks(double) const
    {
      return {};
    }

    /// Profile coordinate of the shock whose position a study reports, cm.
    virtual std::optional<double>
    shock_position(double) const
    {
      return std::nullopt;
    }

  private:
    std::string name_;
  };
} // namespace whipple::exact
