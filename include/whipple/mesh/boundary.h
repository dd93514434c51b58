// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace whipple
{
  /// Material as it is beyond a side before any wave arrives.
  struct SideMedium
  {
    double density = 0; ///< g/cm^3; 0: not given, the material's reference density
    double energy  = 0; ///< specific internal energy, Mbar cm^3/g
  };

  /// What happens at a side of the domain.
  enum class BoundaryKind
  {
    reflecting,    ///< symmetry plane, axis or rigid smooth wall: normal velocity 0
    transmitting,  ///< material leaves; waves in material that touches the side are absorbed
    inflow,        ///< velocity of the side's nodes is prescribed (pistons)
    pressure,      ///< a pressure acts on the material that touches the side, which may leave
    keep_velocity, ///< the side's nodes keep the velocity they have (flows driven from outside)
    exact          ///< the side's nodes have the velocity of the scene's exact solution
  };

  /// One side of the domain.
  template <int dim>
  struct Boundary
  {
    BoundaryKind            kind = BoundaryKind::transmitting;
    std::array<double, dim> velocity{};   ///< cm/us, of `inflow` and of the medium beyond a transmitting side
    double                  pressure = 0; ///< Mbar, of `pressure` and of the medium beyond a transmitting side

    /// `transmitting` only: the medium goes on beyond the side with the pressure, the velocity and (by material) the
    /// state given here, and presses on what touches the side. Without it nothing is there that presses, and material
    /// that carries no stress leaves freely.
    bool                    keeps_ambient = false;
    std::vector<SideMedium> medium;

    /// Velocity (cm/us) at a point (cm) and a time (us), for `exact` only.
    std::function<Vector<dim>(const Vector<dim> &x, double time)> motion;

    /// Axis along which a mesh map has turned the side's normal; none: the side's own axis.
    int turned_axis = none;
  };

  /// All sides, ordered 2 * axis + {0 lower, 1 upper}.
  template <int dim>
  using Boundaries = std::array<Boundary<dim>, 2 * dim>;

  /// Axis normal to a side.
  template <int dim>
  int
  normal_axis(const Boundaries<dim> &boundaries, int side)
  {
    return boundaries[side].turned_axis == none ? side / 2 : boundaries[side].turned_axis;
  }

  /// Whether the velocity of a side's nodes is given, all components of it.
  inline bool
  gives_velocity(BoundaryKind kind)
  {
    return kind == BoundaryKind::inflow || kind == BoundaryKind::keep_velocity || kind == BoundaryKind::exact;
  }

  /// The side that says what component `axis` of a node's velocity is, `none` if it is free: a reflecting side, else
  /// the first that gives velocities.
  /// @param sides the sides that the node lies on, a bit each
  template <int dim>
  int
  ruling_side(const Boundaries<dim> &boundaries, std::uint8_t sides, int axis)
  {
    int ruling = none;
    for (int side = 2 * dim - 1; side >= 0; --side)
      if ((sides >> side & 1) && gives_velocity(boundaries[side].kind))
        ruling = side;
    for (int side = 0; side < 2 * dim; ++side)
      if ((sides >> side & 1) && boundaries[side].kind == BoundaryKind::reflecting &&
          normal_axis<dim>(boundaries, side) == axis)
        ruling = side;
    return ruling;
  }

  /// Component `axis` of the velocity that a ruling side gives a node.
  /// @param present what it is now
  template <int dim>
  double
  ruled_velocity(const Boundary<dim> &boundary, int axis, double present, const Vector<dim> &x, double time)
  {
    switch (boundary.kind)
      {
      case BoundaryKind::inflow:
        return boundary.velocity[axis];
      case BoundaryKind::keep_velocity:
        return present;
      case BoundaryKind::exact:
        return boundary.motion(x, time)[axis];
      default:
        return 0.;
      }
  }
} // namespace whipple
