// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

#include <array>
#include <vector>

namespace whipple
{
  /// Velocities of cell corners, which a regrid or projection changes cell by cell, before gather_velocities()
  /// makes nodes of them.
  ///
  /// The kinetic energy of a cell is sum_k m_k u_k^2/2 over its corners plus `kinetic_remainder`: energy that
  /// the corner velocities do not show, because a hanging corner's mass moves with its two masters (u_a, u_b)
  /// and thus holds m/2 (u_a^2 + u_b^2)/2 = m v_h^2/2 + m |u_a - u_b|^2/8, or because a remap smoothed the
  /// velocities. gather_velocities() turns what it cannot give back to the nodes into heat.
  template <int dim>
  struct CornerVelocities
  {
    std::array<std::vector<double>, dim> velocity;          ///< [n_cells * corners] cm/us
    std::vector<double>                  kinetic_remainder; ///< [n_cells] Mbar cm^3, >= 0

    /// All zero, for that many cells.
    explicit CornerVelocities(Index n_cells)
      : kinetic_remainder(n_cells, 0.)
    {
      for (auto &v : velocity)
        v.assign(static_cast<std::size_t>(n_cells) << dim, 0.);
    }
  };

  /// Mass of all materials of a cell, g.
  template <int dim>
  double
  cell_mass(const State<dim> &state, Index cell);

  /// Share of the cell's mass at each corner: its corner weights, which sum to 1.
  template <int dim>
  std::array<double, 1 << dim>
  corner_shares(const State<dim> &state, Index cell);

  /// Corner velocities of a state's nodes (hanging nodes: the mean of their masters) and the kinetic energy
  /// of hanging corners, so that sum over cells of kinetic energy = sum over nodes of m v^2/2.
  template <int dim>
  CornerVelocities<dim>
  corner_velocities(const FlatMesh<dim> &mesh, const State<dim> &state);
} // namespace whipple
