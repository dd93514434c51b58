// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/step_work.h>
#include <whipple/material/material.h>
#include <whipple/mesh/boundary.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

namespace whipple
{
  /// A material beyond a transmitting side, at rest: what a finite wave runs into.
  struct BeyondSide
  {
    double pressure  = 0; ///< Mbar
    double density   = 0; ///< g/cm^3
    double impedance = 0; ///< rho c of its bulk, g/(cm^2 us); 0: unknown
  };

  /// What a wave that leaves through a side meets, per unit area: the traction along the outward normal n is
  /// -(pressure + normal (v - v_ambient).n), across it -tangential (v - v_ambient). Equations:
  /// doc/theory/lagrange_step.md, "Sides".
  struct OutgoingWave
  {
    double pressure   = 0; ///< of the deviator, Mbar
    double normal     = 0; ///< impedance, g/(cm^2 us)
    double tangential = 0; ///< impedance, g/(cm^2 us)
  };

  /// Where a cell touches a side.
  struct SideContact
  {
    Index  cell;
    int    axis;    ///< normal to the side
    double opening; ///< outward velocity of the cell's nodes on the side minus that of the opposite ones, cm/us
    double depth;   ///< extent of the cell across the side, cm
    double sliding; ///< speed along the side, relative to the ambient, cm/us
  };

  /// State of a material beyond a side: as the side says, or at its reference density without energy.
  template <int dim>
  BeyondSide
  beyond_side(const Boundary<dim> &boundary, std::size_t material, const EquationOfState &eos);

  /// Impedance that a wave of finite amplitude has on its way into the medium beyond: the slope of the line from the
  /// ambient state to the present one in the plane of stress and specific volume. A shock has it exactly, a weak wave
  /// to third order in its strain. It is kept between those of the two states; in a shock up to `steepening` above.
  /// @param stress pressure and artificial viscosity of the material, Mbar
  /// @param steepening artificial viscosity over the jump of velocity across the cell, g/(cm^2 us)
  double
  secant_impedance(const BeyondSide &ambient, double stress, double density, double sound_speed, double steepening);

  /// The wave that leaves a cell through a side, the materials weighted with their shares of the cell.
  template <int dim>
  OutgoingWave
  outgoing_wave(const SideContact &at, const std::vector<BeyondSide> &beyond, const State<dim> &state,
                const Derived &derived, double dt, const StepWork<dim> &work);
} // namespace whipple
