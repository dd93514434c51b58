// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/limited_slope.h>
#include <whipple/remap/momentum_transport.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  template <int dim>
  MomentumTransport<dim>::MomentumTransport(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries,
                                            const RemapParameters &parameters)
    : mesh_(&mesh)
    , boundaries_(boundaries)
    , parameters_(parameters)
    , least_heat_to_spare_(least_heat_to_spare(parameters))
    , nodes_(mesh)
    , dual_(mesh, nodes_)
    , excess_(mesh.n_nodes, 0.)
    , specific_loss_(mesh.n_nodes, 0.)
  {
    for (int d = 0; d < dim; ++d)
      {
        up_[d].assign(mesh.n_nodes, 0.);
        down_[d].assign(mesh.n_nodes, 0.);
        gradient_[d].assign(mesh.n_nodes, 0.);
      }
    drained_.reserve(mesh.n_nodes);
    mixed_.reserve(mesh.n_nodes);
  }

  template <int dim>
  void
  MomentumTransport<dim>::upwind_velocities(const State<dim> &state, const int axis,
                                            const std::vector<double> &mass_after)
  {
    constexpr double round_off = 1e-12;
    drained_.clear();
    for (Index n = 0; n < mesh_->n_nodes; ++n)
      {
        const NodeBalance &b    = dual_.balance[n];
        const double       mass = state.node_mass[n];
        for (int d = 0; d < dim; ++d)
          up_[d][n] = down_[d][n] = state.velocity[d][n];
        excess_[n] = 0;
        if (nodes_.uneven[n])
          for (int d = 0; d < dim; ++d)
            gradient_[d][n] = 0;
        // what gives all it held counts: round-off may not decide whether it has slopes
        if (b.up + b.down + b.aside > (1. - round_off) * mass)
          drained_.push_back(n);
        else if (parameters_.second_order && b.up + b.down > 0)
          {
            nodes_.uneven[n] ? reconstruct_uneven(state, axis, n) : reconstruct(state, axis, n);
            if (excess_[n] > least_heat_to_spare_)
              flatten_to_heat_to_spare(state, axis, mass_after, n);
          }
      }
  }

  template <int dim>
  std::vector<std::vector<double> *>
  MomentumTransport<dim>::arrays_given()
  {
    std::vector<std::vector<double> *> arrays{&excess_};
    for (auto &component : up_)
      arrays.push_back(&component);
    return arrays;
  }

  template <int dim>
  bool
  MomentumTransport<dim>::mix_once(const State<dim> &state, const int axis, const Index n, Mixture &mixed) const
  {
    constexpr double round_off = 2e-15;
    const Mixture    given     = given_by(n);
    mixed                      = given;
    // seen from what it gives, a node's outflow has no momentum: held + inflow remain
    Exchange exchange;
    gather_drained(state, axis, n, given.velocity, exchange);
    const double spread  = std::sqrt(std::abs(exchange.square) / exchange.inflow);
    bool         changed = false;
    // what is nothing but round-off stays as it is: the next pass must not depend on how many went before
    for (int d = 0; d < dim; ++d)
      {
        const int s = ruling_side<dim>(boundaries_, mesh_->node_side[n], d);
        // what flows in from beyond a symmetry plane brings the opposite normal momentum
        const bool   mirrored = s != none && boundaries_[s].kind == BoundaryKind::reflecting;
        const double change   = mirrored ? -given.velocity[d] : exchange.momentum[d] / exchange.inflow;
        if (!(std::abs(change) > round_off * (std::abs(given.velocity[d]) + spread)))
          continue;
        mixed.velocity[d] += change;
        changed = true;
      }
    const double out    = exchange.inflow - dual_.balance[n].mass;
    const double loss   = 0.5 * exchange.square - out * given.excess;
    const double excess = -loss / exchange.inflow;
    if (std::abs(excess - given.excess) > 10. * round_off * (std::abs(excess) + std::abs(given.excess)))
      {
        mixed.excess = excess;
        changed      = true;
      }
    return changed;
  }

  template <int dim>
  void
  MomentumTransport<dim>::mix_drained_nodes(const State<dim> &state, const int axis, const MeetingHalo<dim> &halo)
  {
    if (!halo.any(!drained_.empty()))
      return;
    // drained nodes may feed each other, also in circles: each pass brings them nearer to what they all give
    constexpr int                            most_passes = 200;
    const std::vector<std::vector<double> *> given       = arrays_given();
    mixed_.resize(drained_.size());
    for (int pass = 0; pass < most_passes; ++pass)
      {
        bool changed = false;
        for (std::size_t i = 0; i < drained_.size(); ++i)
          if (at_owned_cell(drained_[i]))
            changed |= mix_once(state, axis, drained_[i], mixed_[i]);
          else
            mixed_[i] = given_by(drained_[i]);
        if (!halo.any(changed))
          break;
        for (std::size_t i = 0; i < drained_.size(); ++i)
          {
            for (int d = 0; d < dim; ++d)
              up_[d][drained_[i]] = mixed_[i].velocity[d];
            excess_[drained_[i]] = mixed_[i].excess;
          }
        // a chain of them may be longer than the halo is wide
        halo.exchange({}, given);
        for (const Index n : drained_)
          for (int d = 0; d < dim; ++d)
            down_[d][n] = up_[d][n];
      }
  }

  template <int dim>
  Vector<dim>
  MomentumTransport<dim>::carried_along(const Index from, const bool up, const double half) const
  {
    Vector<dim> velocity;
    for (int d = 0; d < dim; ++d)
      velocity[d] = up ? up_[d][from] + gradient_[d][from] * half : down_[d][from] - gradient_[d][from] * half;
    return velocity;
  }

  template <int dim>
  Vector<dim>
  MomentumTransport<dim>::carried_across(const Index from) const
  {
    Vector<dim> velocity;
    for (int d = 0; d < dim; ++d)
      velocity[d] = 0.5 * (up_[d][from] + down_[d][from]);
    return velocity;
  }

  template <int dim>
  void
  MomentumTransport<dim>::add_flux(const Index from, const std::array<std::vector<double>, dim> &upwind,
                                   const double flux, const double excess, const Vector<dim> &velocity,
                                   Exchange &exchange) const
  {
    Vector<dim> carried;
    for (int d = 0; d < dim; ++d)
      carried[d] = upwind[d][from];
    add_flux(carried, flux, excess, velocity, exchange);
  }

  template <int dim>
  void
  MomentumTransport<dim>::add_flux(const Vector<dim> &carried, const double flux, const double excess,
                                   const Vector<dim> &velocity, Exchange &exchange) const
  {
    double square = 0;
    for (int d = 0; d < dim; ++d)
      {
        const double u = carried[d] - velocity[d];
        exchange.momentum[d] += flux * u;
        square += u * u;
      }
    exchange.square += flux * (square - 2. * excess);
    exchange.inflow += std::max(flux, 0.);
  }

  template <int dim>
  void
  MomentumTransport<dim>::gather_interior(const int axis, const Index node, const Vector<dim> &velocity,
                                          Exchange &exchange) const
  {
    const int axis_bit = 1 << axis;
    for (Index i = mesh_->node_corner_begin[node]; i < mesh_->node_corner_begin[node + 1]; ++i)
      {
        const Index  corner = mesh_->node_corner[i], c = corner >> 2;
        const int    l = corner >> axis & 1, t = corner >> (1 - axis) & 1;
        const double inwards = l ? dual_.along[2 * c + t] : -dual_.along[2 * c + t];
        if (inwards > 0)
          {
            const Index from = mesh_->cell_node[corner ^ axis_bit];
            add_flux(from, l ? up_ : down_, inwards, excess_[from], velocity, exchange);
          }
        else if (inwards < 0)
          add_flux(node, l ? down_ : up_, inwards, excess_[node], velocity, exchange);
      }
  }

  template <int dim>
  void
  MomentumTransport<dim>::gather_special(const int axis, const Index node, const Index corner_node, const double share,
                                         const Vector<dim> &velocity, Exchange &exchange) const
  {
    const auto add = [&](const double inwards, const Index other, const auto &carried) {
      if (inwards < 0)
        add_flux(carried(node), share * inwards, excess_[node], velocity, exchange);
      else if (inwards > 0 && nodes_.kind[other] != NodeKind::hanging)
        add_flux(carried(other), share * inwards, excess_[other], velocity, exchange);
      else if (inwards > 0) // a hanging node gives what its masters have, an equal part each
        for (const Index master : mesh_->master[nodes_.hanging_place[other]])
          add_flux(carried(master), Masters<dim>::weight * share * inwards, excess_[master], velocity, exchange);
    };
    for (Index i = mesh_->node_corner_begin[corner_node]; i < mesh_->node_corner_begin[corner_node + 1]; ++i)
      {
        const Index  corner = mesh_->node_corner[i], c = corner >> 2;
        const int    l = corner >> axis & 1, t = corner >> (1 - axis) & 1;
        const double along = dual_.along[2 * c + t], across = dual_.across[2 * c + l];
        const Index  other = mesh_->cell_node[corner ^ (1 << axis)];
        const double half  = 0.5 * std::abs(mesh_->node_point[axis][other] - mesh_->node_point[axis][corner_node]);
        // what flows up leaves the node below, what flows down the one above
        const bool flows_up = along > 0;
        add(l ? along : -along, other, [&](Index from) { return carried_along(from, flows_up, half); });
        add(t ? across : -across, mesh_->cell_node[corner ^ (2 >> axis)],
            [&](Index from) { return carried_across(from); });
      }
  }

  template <int dim>
  void
  MomentumTransport<dim>::gather(const State<dim> &state, const int axis, const Index node, const Vector<dim> &velocity,
                                 Exchange &exchange) const
  {
    if (nodes_.kind[node] == NodeKind::interior)
      return gather_interior(axis, node, velocity, exchange);
    gather_special(axis, node, node, 1., velocity, exchange);
    for (const Index h : nodes_.hanging_of(node))
      gather_special(axis, node, h, Masters<dim>::weight, velocity, exchange);
    if (nodes_.on_side(node, axis))
      {
        add_flux(node, up_, -dual_.boundary_out[node], excess_[node], velocity, exchange);
        add_flux(node, state.velocity, dual_.boundary_in[node], 0., velocity, exchange); // zero gradient
      }
  }

  template <int dim>
  void
  MomentumTransport<dim>::gather_drained(const State<dim> &state, const int axis, const Index node,
                                         const Vector<dim> &velocity, Exchange &exchange) const
  {
    gather(state, axis, node, velocity, exchange);
    add_flux(node, state.velocity, state.node_mass[node], 0., velocity, exchange); // what it held
  }

  template <int dim>
  Vector<dim>
  MomentumTransport<dim>::first_velocity(const int axis, const Index node) const
  {
    // the mean of all that flows in, as seen from the first of it: what is equal stays equal to the last bit
    Vector<dim> velocity{};
    const auto  search = [&](const Index corner_node) {
      for (Index i = mesh_->node_corner_begin[corner_node]; i < mesh_->node_corner_begin[corner_node + 1]; ++i)
        {
          const Index  corner = mesh_->node_corner[i], c = corner >> 2;
          const int    l = corner >> axis & 1, t = corner >> (1 - axis) & 1;
          const double along = dual_.along[2 * c + t], across = dual_.across[2 * c + l];
          const bool   in_along = (l ? along : -along) > 0, in_across = (t ? across : -across) > 0;
          if (!in_along && !in_across)
            continue;
          const Index from = mesh_->cell_node[corner ^ (in_along ? 1 << axis : 2 >> axis)];
          const Index source =
              nodes_.kind[from] == NodeKind::hanging ? mesh_->master[nodes_.hanging_place[from]][0] : from;
          for (int d = 0; d < dim; ++d)
            velocity[d] = (in_along && !l ? down_ : up_)[d][source];
          return true;
        }
      return false;
    };
    bool found = search(node);
    for (const Index h : nodes_.hanging_of(node))
      found = found || search(h);
    return velocity;
  }

  template <int dim>
  void
  MomentumTransport<dim>::change_of(const State<dim> &state, const int axis, const Index node, const bool drained,
                                    Change &change) const
  {
    const double mass_before = state.node_mass[node], mass = dual_.balance[node].mass;
    if (drained)
      {
        change.reference = given_by(node).velocity;
        gather_drained(state, axis, node, change.reference, change.exchange);
        // what is left keeps the mixture
        return;
      }
    for (int d = 0; d < dim; ++d)
      change.reference[d] = state.velocity[d][node];
    if (mass_before == 0)
      change.reference = first_velocity(axis, node);
    gather(state, axis, node, change.reference, change.exchange);
    // the same to round-off; the larger keeps the result between the velocities that meet
    const double divisor = std::max(mass, change.exchange.inflow);
    for (int d = 0; d < dim && mass > 0; ++d)
      change.velocity[d] = change.exchange.momentum[d] / divisor;
  }

  template <int dim>
  void
  MomentumTransport<dim>::constrain(const Index node, const double time, Change &change, RemapSums<dim> &report) const
  {
    Vector<dim> x;
    for (int d = 0; d < dim; ++d)
      x[d] = mesh_->node_point[d][node];
    for (int d = 0; d < dim; ++d)
      {
        const int s = ruling_side<dim>(boundaries_, mesh_->node_side[node], d);
        if (s == none)
          continue;
        const double velocity = ruled_velocity<dim>(boundaries_[s], d, change.reference[d], x, time);
        change.velocity[d]    = velocity - change.reference[d];
        if (counts(node))
          {
            const double taken = change.exchange.momentum[d] - dual_.balance[node].mass * change.velocity[d];
            report.side[s].momentum[d] += taken;
            report.side[s].kinetic += velocity * taken;
          }
      }
  }

  template <int dim>
  void
  MomentumTransport<dim>::update_nodes(State<dim> &state, const int axis, RemapSums<dim> &report)
  {
    std::size_t next_drained = 0; // drained_ is in the order of the nodes
    for (Index n = 0; n < mesh_->n_nodes; ++n)
      {
        const double mass = dual_.balance[n].mass;
        specific_loss_[n] = 0;
        if (nodes_.kind[n] == NodeKind::hanging || (state.node_mass[n] == 0 && mass == 0))
          {
            state.node_mass[n] = 0;
            for (int d = 0; d < dim; ++d)
              state.velocity[d][n] = 0;
            continue;
          }
        const bool drained = next_drained < drained_.size() && drained_[next_drained] == n;
        Change     change;
        next_drained += drained;
        change_of(state, axis, n, drained, change);
        if (mesh_->node_side[n])
          constrain(n, state.time, change, report);
        double loss = 0.5 * change.exchange.square;
        for (int d = 0; d < dim; ++d)
          {
            const double delta   = change.velocity[d];
            state.velocity[d][n] = mass > 0 ? change.reference[d] + delta : 0.;
            loss -= delta * (change.exchange.momentum[d] - 0.5 * mass * delta);
          }
        if (mass > 0)
          specific_loss_[n] = loss / mass;
        if (counts(n))
          report.kinetic_lost += loss;
        state.node_mass[n] = mass;
      }
    for (auto &component : state.velocity)
      mesh_->hang(component);
    mesh_->hang(specific_loss_);
  }

  template <int dim>
  void
  MomentumTransport<dim>::book_boundaries(const State<dim> &state, const SweepTopology<dim> &topology,
                                          const std::vector<double> &mass_flux, RemapSums<dim> &report) const
  {
    const FlatFaces<dim> &faces = *topology.faces;
    for (const Index f : topology.boundary_faces)
      {
        const int   upper = faces.side[f] & 1;
        const Index cell  = faces.cell[1 - upper][f];
        if (mass_flux[f] == 0 || cell >= mesh_->n_owned)
          continue;
        SideFlux<dim> &side = report.side[faces.side[f]];
        for (int t = 0; t < 2; ++t)
          {
            const Index  n = faces.node[2 * f + t];
            const double outwards =
                (upper ? mass_flux[f] : -mass_flux[f]) * nodes_.transverse_share(state, cell, topology.axis, t);
            for (int d = 0; d < dim; ++d)
              {
                const double v = outwards > 0 ? up_[d][n] : state.velocity[d][n];
                side.momentum[d] += outwards * v;
                side.kinetic += 0.5 * outwards * v * v;
              }
            if (outwards > 0)
              {
                // heat of mixing in a node that gave all it had leaves with what it gave
                const double heat = -excess_[n] * outwards;
                report.kinetic_lost += heat;
                if (parameters_.kinetic_loss_to_heat)
                  {
                    report.kinetic_heated += heat;
                    side.internal += heat;
                  }
              }
          }
      }
  }

  template <int dim>
  void
  MomentumTransport<dim>::heat_cells(State<dim> &state, const std::vector<double> &mass_after,
                                     RemapSums<dim> &report) const
  {
    for (Index c = 0; c < mesh_->n_cells; ++c)
      {
        if (!(mass_after[c] > 0))
          continue;
        double heat = 0;
        for (int k = 0; k < FlatMesh<dim>::corners; ++k)
          heat += state.corner_weight[4 * c + k] * specific_loss_[mesh_->cell_node[4 * c + k]];
        for (MaterialState &material : state.material)
          if (material.mass[c] > 0)
            material.energy[c] += heat;
        if (c < mesh_->n_owned)
          report.kinetic_heated += heat * mass_after[c];
      }
  }

  template <int dim>
  void
  MomentumTransport<dim>::move(State<dim> &state, const SweepTopology<dim> &topology,
                               const std::vector<double> &mass_flux, const std::vector<double> &mass_before,
                               const std::vector<double> &mass_after, const MeetingHalo<dim> &halo,
                               RemapSums<dim> &report)
  {
    dual_.compute(state, topology, mass_flux, mass_before, mass_after);
    upwind_velocities(state, topology.axis, mass_after);
    mix_drained_nodes(state, topology.axis, halo);
    book_boundaries(state, topology, mass_flux, report);
    update_nodes(state, topology.axis, report);
    if (parameters_.kinetic_loss_to_heat)
      heat_cells(state, mass_after, report);
  }

  template class MomentumTransport<2>;
} // namespace whipple
