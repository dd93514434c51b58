// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/dual_flux.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  template <int dim>
  DualFlux<dim>::DualFlux(const FlatMesh<dim> &mesh, const NodeTopology<dim> &nodes)
    : along(2 * mesh.n_cells, 0.)
    , across(2 * mesh.n_cells, 0.)
    , balance(mesh.n_nodes)
    , boundary_in(mesh.n_nodes, 0.)
    , boundary_out(mesh.n_nodes, 0.)
    , mesh_(&mesh)
    , nodes_(&nodes)
  {
  }

  template <int dim>
  void
  DualFlux<dim>::edge_fluxes(const State<dim> &state, const SweepTopology<dim> &topology,
                             const std::vector<double> &mass_flux, const std::vector<double> &mass_before,
                             const std::vector<double> &mass_after)
  {
    const int axis_bit = 1 << topology.axis, transverse_bit = 3 ^ axis_bit;
    for (Index c = 0; c < mesh_->n_cells; ++c)
      {
        const double  in     = mass_flux[topology.lower[0][c]] + mass_flux[topology.lower[1][c]];
        const double  change = mass_after[c] - mass_before[c];
        const double *w      = &state.corner_weight[4 * c];
        along[2 * c]         = (w[0] + w[axis_bit]) * in - w[0] * change;
        along[2 * c + 1]     = (w[transverse_bit] + w[3]) * in - w[transverse_bit] * change;
      }
  }

  template <int dim>
  void
  DualFlux<dim>::coarse_side_fluxes(const State<dim> &state, const SweepTopology<dim> &topology,
                                    const std::vector<double> &mass_flux)
  {
    // where a side has two subfaces, what they bring to its corners differs from the cell's own shares
    const int             axis_bit = 1 << topology.axis;
    const FlatFaces<dim> &faces    = *topology.faces;
    for (const Index c : nodes_->coarse_cells[topology.axis])
      for (int l = 0; l < 2; ++l)
        {
          const auto  &side  = l ? topology.upper : topology.lower;
          const double whole = state.corner_weight[4 * c] + state.corner_weight[4 * c + axis_bit];
          double       total = 0, first = 0; // through the side, and of it what reaches the corner t = 0
          for (int s = 0; s < 2; ++s)
            if (const Index f = side[s][c];
                f != topology.n_faces && faces.part[1 - l][f] >= 0 && faces.cell[l][f] != none)
              {
                const Index   fine  = faces.cell[l][f];
                const double *w     = &state.corner_weight[4 * fine];
                const double  inner = w[0] + w[axis_bit], flux = mass_flux[f];
                total += flux;
                first += faces.part[1 - l][f] == 0 ? flux * (inner + 0.5 * (1. - inner)) : flux * 0.5 * inner;
              }
          across[2 * c + l] = l ? whole * total - first : first - whole * total;
        }
  }

  template <int dim>
  void
  DualFlux<dim>::balance_corners(const State<dim> &state, const int axis, const Index node,
                                 const std::vector<double> &mass_after, const double share, NodeBalance &sum) const
  {
    for (Index i = mesh_->node_corner_begin[node]; i < mesh_->node_corner_begin[node + 1]; ++i)
      {
        const Index  corner = mesh_->node_corner[i], c = corner >> 2;
        const int    l = corner >> axis & 1, t = corner >> (1 - axis) & 1;
        const double up_or_down = l ? -along[2 * c + t] : along[2 * c + t]; // away from the node
        const double sideways   = t ? -across[2 * c + l] : across[2 * c + l];
        sum.mass += share * (state.corner_weight[corner] * mass_after[c]);
        (l ? sum.down : sum.up) += share * std::max(up_or_down, 0.);
        sum.aside += share * std::max(sideways, 0.);
      }
  }

  template <int dim>
  void
  DualFlux<dim>::balance_nodes(const State<dim> &state, const SweepTopology<dim> &topology,
                               const std::vector<double> &mass_flux, const std::vector<double> &mass_after)
  {
    for (Index n = 0; n < mesh_->n_nodes; ++n)
      {
        NodeBalance sum;
        if (nodes_->kind[n] != NodeKind::hanging)
          balance_corners(state, topology.axis, n, mass_after, 1., sum);
        if (nodes_->kind[n] == NodeKind::special)
          for (const Index h : nodes_->hanging_of(n))
            balance_corners(state, topology.axis, h, mass_after, 0.5, sum);
        balance[n] = sum;
      }

    // through the sides of the domain
    const FlatFaces<dim> &faces = *topology.faces;
    for (const Index f : topology.boundary_faces)
      for (int t = 0; t < 2; ++t)
        boundary_in[faces.node[2 * f + t]] = boundary_out[faces.node[2 * f + t]] = 0;
    for (const Index f : topology.boundary_faces)
      for (int t = 0; t < 2; ++t)
        {
          const int    upper    = faces.side[f] & 1;
          const double outwards = (upper ? mass_flux[f] : -mass_flux[f]) *
                                  nodes_->transverse_share(state, faces.cell[1 - upper][f], topology.axis, t);
          (outwards > 0 ? boundary_out : boundary_in)[faces.node[2 * f + t]] += std::abs(outwards);
        }
    for (const Index n : nodes_->side_nodes[topology.axis])
      balance[n].aside += boundary_out[n];
  }

  template <int dim>
  void
  DualFlux<dim>::compute(const State<dim> &state, const SweepTopology<dim> &topology,
                         const std::vector<double> &mass_flux, const std::vector<double> &mass_before,
                         const std::vector<double> &mass_after)
  {
    // cells that are coarse only across the other axis have no transverse flux in this sweep
    for (const std::vector<Index> &cells : nodes_->coarse_cells)
      for (const Index c : cells)
        across[2 * c] = across[2 * c + 1] = 0;
    edge_fluxes(state, topology, mass_flux, mass_before, mass_after);
    coarse_side_fluxes(state, topology, mass_flux);
    balance_nodes(state, topology, mass_flux, mass_after);
  }

  template class DualFlux<2>;
} // namespace whipple
