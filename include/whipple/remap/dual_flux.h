// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/remap/node_topology.h>
#include <whipple/remap/sweep_topology.h>
#include <whipple/state/fields.h>

#include <vector>

namespace whipple
{
  /// Mass of a node in a sweep.
  struct NodeBalance
  {
    double mass = 0;                    ///< after the sweep
    double up = 0, down = 0, aside = 0; ///< leaving along + axis, - axis, across or through sides of the domain
  };

  /// Mass that passes between nodes in a sweep, so that every corner keeps its share of the mass of its cell
  /// (G and T of doc/theory/remap.md).
  template <int dim>
  class DualFlux
  {
  public:
    DualFlux(const FlatMesh<dim> &mesh, const NodeTopology<dim> &nodes);

    /// Fill the arrays below.
    /// @param mass_flux   [face + 1] of all materials, along + axis
    /// @param mass_before, mass_after [cell] of all materials, around the sweep
    void
    compute(const State<dim> &state, const SweepTopology<dim> &topology, const std::vector<double> &mass_flux,
            const std::vector<double> &mass_before, const std::vector<double> &mass_after);

    std::vector<double>      along;                     ///< [cell * 2 + t] along + axis between the corners t
    std::vector<double>      across;                    ///< [cell * 2 + l] from corner t = 0 to t = 1 of side l
    std::vector<NodeBalance> balance;                   ///< [node], with what hanging nodes give to their masters
    std::vector<double>      boundary_in, boundary_out; ///< [node] through sides normal to the axis

  private:
    void
    edge_fluxes(const State<dim> &state, const SweepTopology<dim> &topology, const std::vector<double> &mass_flux,
                const std::vector<double> &mass_before, const std::vector<double> &mass_after);
    void
    coarse_side_fluxes(const State<dim> &state, const SweepTopology<dim> &topology,
                       const std::vector<double> &mass_flux);
    void
    balance_corners(const State<dim> &state, int axis, Index node, const std::vector<double> &mass_after, double share,
                    NodeBalance &balance) const;
    void
    balance_nodes(const State<dim> &state, const SweepTopology<dim> &topology, const std::vector<double> &mass_flux,
                  const std::vector<double> &mass_after);

    const FlatMesh<dim>     *mesh_;
    const NodeTopology<dim> *nodes_;
  };
} // namespace whipple
