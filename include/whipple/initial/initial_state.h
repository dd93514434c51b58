// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_solution.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/problem/field_layout.h>
#include <whipple/state/corner_velocity.h>
#include <whipple/state/fields.h>

#include <array>
#include <vector>

namespace whipple
{
  /// What a body puts into one cell.
  template <int dim>
  struct CellFilling
  {
    double                            density = 0; ///< g/cm^3
    double                            energy  = 0; ///< Mbar cm^3/g
    std::array<Vector<dim>, 1 << dim> velocity{};  ///< of its corners, cm/us
  };

  /// Fills the cells of bodies with an exact solution, that of a scene or the expressions of a body: mean density and
  /// energy over the cell (where the solution has material; of a cell that the body cuts, that of the whole cell), and
  /// the velocity of the solution at the nodes, so that smooth flows start with errors of second order. Hanging nodes
  /// follow their masters.
  template <int dim>
  class ExactFilling
  {
  public:
    /// @param state positions and volumes of the mesh at the time of the filling
    ExactFilling(const exact::ExactSolution<dim> &solution, const FieldLayout &layout, const FlatMesh<dim> &mesh,
                 const State<dim> &state);

    /// @throws StateError where the solution gives no density, velocity, or neither energy nor pressure
    CellFilling<dim>
    fill(const Body<dim> &body, const State<dim> &state, Index cell) const;

    /// Give the cells marked, which hold nothing else, the kinetic energy of their hanging corners, which move with
    /// two masters (CornerVelocities).
    void
    add_hanging_energy(const State<dim> &state, const std::vector<std::uint8_t> &marked,
                       CornerVelocities<dim> &corners) const;

  private:
    const exact::ExactSolution<dim> &solution_;
    const FieldLayout               &layout_;
    const FlatMesh<dim>             &mesh_;
    std::vector<Vector<dim>>         node_velocity_;
  };
} // namespace whipple
