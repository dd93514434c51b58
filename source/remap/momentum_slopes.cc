// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/limited_slope.h>
#include <whipple/remap/momentum_transport.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// What the kinetic energy of slopes may take in one sweep of the heat around a receiver ...
    constexpr double spare_share = 0.1;
    /// ... and of c^2 where that is cold: solids may lack a little heat, gases may not.
    constexpr double spare_stiffness = 0.01;
  } // namespace

  template <int dim>
  bool
  MomentumTransport<dim>::moves(const State<dim> &state, const Index node) const
  {
    if (nodes_.kind[node] != NodeKind::hanging)
      return state.node_mass[node] > 0;
    const Masters<dim> &masters = mesh_->master[nodes_.hanging_place[node]];
    return std::all_of(masters.begin(), masters.end(), [&](Index master) { return state.node_mass[master] > 0; });
  }

  template <int dim>
  void
  MomentumTransport<dim>::reconstruct(const State<dim> &state, const int axis, const Index node)
  {
    const Index p = nodes_.previous[axis][node], q = nodes_.next[axis][node];
    if (p == node || q == node)
      return reconstruct_at_plane(state, axis, node);
    if (!moves(state, p) || !moves(state, q))
      return;
    const double up   = dual_.balance[node].up / state.node_mass[node],
                 down = dual_.balance[node].down / state.node_mass[node];
    double square     = 0;
    for (int d = 0; d < dim; ++d)
      {
        const double v = state.velocity[d][node], low = v - state.velocity[d][p], high = state.velocity[d][q] - v;
        // one profile a node: a parabola's part where all leaves through one end
        const double curved = down == 0 ? curvature_slope(low, high, 1. - up)
                              : up == 0 ? curvature_slope(high, low, 1. - down)
                                        : 0.;
        const double slope  = limited_slope(low, high, 0.5 * (low + high) + curved);
        up_[d][node]        = v + 0.5 * slope * (1. - up);
        down_[d][node]      = v - 0.5 * slope * (1. - down);
        square += 0.25 * slope * slope;
      }
    // kinetic energy of the slope in what leaves and what stays, which the node's mean velocity does not have
    const double rest = std::max(1. - up - down, 0.);
    excess_[node]     = 0.5 * square *
                    (up * (1. - up) * (1. - up) + down * (1. - down) * (1. - down) + rest * (up - down) * (up - down)) /
                    (up + down);
  }

  template <int dim>
  std::array<double, 2>
  MomentumTransport<dim>::half_edges(const int axis, const Index node) const
  {
    std::array<double, 2> half{0., 0.};
    for (Index i = mesh_->node_corner_begin[node]; i < mesh_->node_corner_begin[node + 1]; ++i)
      {
        const Index  corner = mesh_->node_corner[i];
        const double edge =
            std::abs(mesh_->node_point[axis][mesh_->cell_node[corner ^ (1 << axis)]] - mesh_->node_point[axis][node]);
        double &longest = half[1 - (corner >> axis & 1)];
        longest         = std::max(longest, 0.5 * edge);
      }
    return half;
  }

  template <int dim>
  void
  MomentumTransport<dim>::reconstruct_at_plane(const State<dim> &state, const int axis, const Index node)
  {
    const bool  lower  = nodes_.previous[axis][node] == node;
    const Index inside = (lower ? nodes_.next : nodes_.previous)[axis][node];
    const int   side   = 2 * axis + (lower ? 0 : 1);
    if (inside == node || !(mesh_->node_side[node] >> side & 1) || boundaries_[side].kind != BoundaryKind::reflecting ||
        !moves(state, inside))
      return;
    // the flow beyond is the mirror image: tangential velocities are extreme at the plane, the normal one is straight
    // through it, and the whole node, of twice the mass, gives the same to either side
    const int                   d        = normal_axis<dim>(boundaries_, side);
    const double                share    = (dual_.balance[node].up + dual_.balance[node].down) / state.node_mass[node];
    const std::array<double, 2> edges    = half_edges(axis, node);
    const double                half     = std::max(edges[0], edges[1]);
    const double                distance = mesh_->node_point[axis][inside] - mesh_->node_point[axis][node];
    const double                v        = state.velocity[d][node];
    const double                gradient =
        (state.velocity[d][inside] - v) / std::copysign(std::max(std::abs(distance), half), distance);
    const double swept = 0.5 * share * half, reach = nodes_.uneven[node] ? 0. : half;
    if (nodes_.uneven[node])
      {
        if (!(share < 1))
          return;
        gradient_[d][node] = gradient;
      }
    up_[d][node]   = v + gradient * (reach - swept);
    down_[d][node] = v - gradient * (reach - swept);
    excess_[node]  = 0.5 * gradient * gradient * (half - swept) * (half - swept);
  }

  template <int dim>
  void
  MomentumTransport<dim>::reconstruct_uneven(const State<dim> &state, const int axis, const Index node)
  {
    const Index p = nodes_.previous[axis][node], q = nodes_.next[axis][node];
    if (p == node || q == node)
      return reconstruct_at_plane(state, axis, node);
    if (!moves(state, p) || !moves(state, q))
      return;
    const std::array<double, 2> half = half_edges(axis, node);
    const double                x = mesh_->node_point[axis][node], below = x - mesh_->node_point[axis][p],
                 above = mesh_->node_point[axis][q] - x;
    const double up    = dual_.balance[node].up / state.node_mass[node],
                 down = dual_.balance[node].down / state.node_mass[node], rest = 1. - up - down;
    // how far what leaves has moved
    const double swept_up = 0.5 * up * (half[0] + half[1]), swept_down = 0.5 * down * (half[0] + half[1]);
    double       square = 0;
    for (int d = 0; d < dim; ++d)
      {
        const double v = state.velocity[d][node], low = v - state.velocity[d][p], high = state.velocity[d][q] - v;
        if (!(low * high > 0 && rest > 0))
          continue;
        // parabola through the three nodes; no value beyond the neighbours', neither in what leaves nor in what stays
        const double room     = std::min(std::abs(low), std::abs(high));
        const double slope    = (low * above / below + high * below / above) / (below + above);
        const double taken    = std::abs(up * (half[1] - swept_up) - down * (half[0] - swept_down));
        double       steepest = std::min(std::abs(low) / half[0], std::abs(high) / half[1]);
        if (taken * steepest > rest * room)
          steepest = rest * room / taken;
        const double gradient = std::copysign(std::min(std::abs(slope), steepest), low);
        gradient_[d][node]    = gradient;
        up_[d][node]          = v - gradient * swept_up;
        down_[d][node]        = v + gradient * swept_down;
        const double gives_up = gradient * (half[1] - swept_up), gives_down = -gradient * (half[0] - swept_down);
        const double stays = (up * gives_up + down * gives_down) / rest;
        square += up * gives_up * gives_up + down * gives_down * gives_down + rest * stays * stays;
      }
    excess_[node] = 0.5 * square / (up + down);
  }

  template <int dim>
  double
  MomentumTransport<dim>::heat_to_spare(const double energy, const double cold_stiffness)
  {
    return spare_share * std::max(energy, 0.) + spare_stiffness * cold_stiffness;
  }

  template <int dim>
  double
  MomentumTransport<dim>::least_heat_to_spare(const RemapParameters &parameters)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const double stiffness : parameters.cold_stiffness)
      least = std::min(least, heat_to_spare(0., stiffness));
    return parameters.cold_stiffness.empty() ? 0. : least;
  }

  template <int dim>
  double
  MomentumTransport<dim>::largest_excess(const State<dim> &state, const std::vector<double> &mass_after,
                                         const Index receiver) const
  {
    const NodeBalance &b      = dual_.balance[receiver];
    const double       inflow = b.mass - state.node_mass[receiver] + b.up + b.down + b.aside;
    double             room   = std::numeric_limits<double>::infinity();
    if (!(inflow > 0))
      return room;
    const auto look_around = [&](const Index node) {
      for (Index i = mesh_->node_corner_begin[node]; i < mesh_->node_corner_begin[node + 1]; ++i)
        if (const Index c = mesh_->node_corner[i] / FlatMesh<dim>::corners; mass_after[c] > 0)
          for (std::size_t m = 0; m < state.material.size(); ++m)
            if (state.material[m].mass[c] > 0)
              room = std::min(room, heat_to_spare(state.material[m].energy[c], m < parameters_.cold_stiffness.size()
                                                                                   ? parameters_.cold_stiffness[m]
                                                                                   : 0.));
    };
    look_around(receiver);
    for (const Index h : nodes_.hanging_of(receiver))
      look_around(h);
    return room * b.mass / inflow;
  }

  template <int dim>
  void
  MomentumTransport<dim>::flatten_to_heat_to_spare(const State<dim> &state, const int axis,
                                                   const std::vector<double> &mass_after, const Index node)
  {
    double     room = std::numeric_limits<double>::infinity();
    const auto ask  = [&](const Index receiver) {
      if (nodes_.kind[receiver] != NodeKind::hanging)
        room = std::min(room, largest_excess(state, mass_after, receiver));
      else
        for (const Index master : mesh_->master[nodes_.hanging_place[receiver]])
          room = std::min(room, largest_excess(state, mass_after, master));
    };
    const auto ask_around = [&](const Index at) {
      for (Index i = mesh_->node_corner_begin[at]; i < mesh_->node_corner_begin[at + 1]; ++i)
        {
          const Index  corner = mesh_->node_corner[i], c = corner >> 2;
          const int    l = corner >> axis & 1, t = corner >> (1 - axis) & 1;
          const double along = dual_.along[2 * c + t], across = dual_.across[2 * c + l];
          if ((l ? -along : along) > 0)
            ask(mesh_->cell_node[corner ^ (1 << axis)]);
          if ((t ? -across : across) > 0)
            ask(mesh_->cell_node[corner ^ (2 >> axis)]);
        }
    };
    ask_around(node);
    if (nodes_.kind[node] == NodeKind::special)
      for (const Index h : nodes_.hanging_of(node))
        ask_around(h);
    if (!(excess_[node] > room))
      return;
    const double scale = std::sqrt(room / excess_[node]);
    excess_[node]      = room;
    for (int d = 0; d < dim; ++d)
      {
        const double v = state.velocity[d][node];
        up_[d][node]   = v + scale * (up_[d][node] - v);
        down_[d][node] = v + scale * (down_[d][node] - v);
        if (nodes_.uneven[node])
          gradient_[d][node] *= scale;
      }
  }

  template bool
  MomentumTransport<2>::moves(const State<2> &, Index) const;
  template void
  MomentumTransport<2>::reconstruct(const State<2> &, int, Index);
  template std::array<double, 2>
  MomentumTransport<2>::half_edges(int, Index) const;
  template void
  MomentumTransport<2>::reconstruct_at_plane(const State<2> &, int, Index);
  template void
  MomentumTransport<2>::reconstruct_uneven(const State<2> &, int, Index);
  template double
  MomentumTransport<2>::heat_to_spare(double, double);
  template double
  MomentumTransport<2>::least_heat_to_spare(const RemapParameters &);
  template double
  MomentumTransport<2>::largest_excess(const State<2> &, const std::vector<double> &, Index) const;
  template void
  MomentumTransport<2>::flatten_to_heat_to_spare(const State<2> &, int, const std::vector<double> &, Index);
} // namespace whipple
