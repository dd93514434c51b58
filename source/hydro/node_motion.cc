// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/hydro/node_motion.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace whipple
{
  template <int dim>
  NodeMotion<dim>::NodeMotion(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries,
                              const std::vector<Material> &materials)
    : mesh_(mesh)
    , boundaries_(boundaries)
    , node_owned_(mesh.n_nodes)
  {
    for (Index node = 0; node < mesh.n_nodes; ++node)
      {
        const Index begin = mesh.node_corner_begin[node], end = mesh.node_corner_begin[node + 1];
        node_owned_[node] = begin < end && mesh.node_corner[begin] / FlatMesh<dim>::corners < mesh.n_owned;
      }
    for (Index node = 0; node < mesh.n_nodes; ++node)
      {
        ConstrainedNode constraint{node, node_owned_[node] != 0, {}};
        for (int d = 0; d < dim; ++d)
          constraint.side[d] = ruling_side<dim>(boundaries, mesh.node_side[node], d);
        if (std::any_of(constraint.side.begin(), constraint.side.end(), [](int side) { return side != none; }))
          constrained_.push_back(constraint);
        for (const int side : constraint.side)
          drives_nodes_ = drives_nodes_ || (side != none && (boundaries[side].kind == BoundaryKind::inflow ||
                                                             boundaries[side].kind == BoundaryKind::exact));
      }
    for (int axis = 0; axis < dim; ++axis)
      for (Index face = 0; face < mesh.faces[axis].size(); ++face)
        {
          const int side = mesh.faces[axis].side[face];
          if (side < 0 ||
              (boundaries[side].kind != BoundaryKind::transmitting && boundaries[side].kind != BoundaryKind::pressure))
            continue;
          const bool  upper = side % 2 == 1;
          const Index cell  = mesh.faces[axis].cell[upper ? 0 : 1][face];
          const int   low = upper ? 1 << axis : 0, high = low | (1 << (1 - axis));
          // counter-clockwise around the cell: up its right side, down its left one
          const bool forward = upper == (axis == 0);
          loaded_.push_back({cell, side, {forward ? low : high, forward ? high : low}});
          for (const int k : loaded_.back().corner)
            traction_node_.push_back(mesh.cell_node[cell * 4 + k]);
        }
    std::sort(traction_node_.begin(), traction_node_.end());
    traction_node_.erase(std::unique(traction_node_.begin(), traction_node_.end()), traction_node_.end());
    if (loaded_.empty())
      return;
    for (auto *nodal : {&traction_, &damping_})
      for (auto &component : *nodal)
        component.assign(mesh.n_nodes, 0.);
    beyond_.resize(boundaries.size());
    for (std::size_t side = 0; side < boundaries.size(); ++side)
      for (std::size_t m = 0; m < materials.size(); ++m)
        beyond_[side].push_back(beyond_side(boundaries[side], m, *materials[m].eos));
  }

  template <int dim>
  void
  NodeMotion<dim>::predict(const State<dim> &state, double dt, StepWork<dim> &work) const
  {
    for (int d = 0; d < dim; ++d)
      {
        const double *x = state.position[d].data(), *v = state.velocity[d].data();
        double       *half = work.half_position[d].data();
        for (Index node = 0; node < mesh_.n_nodes; ++node)
          half[node] = x[node] + 0.5 * dt * v[node];
      }
  }

  template <int dim>
  void
  NodeMotion<dim>::drive(const State<dim> &state, std::array<std::vector<double>, dim> &velocity) const
  {
    for (const ConstrainedNode &constraint : constrained_)
      {
        Vector<dim> x;
        for (int d = 0; d < dim; ++d)
          x[d] = state.position[d][constraint.node];
        for (int d = 0; d < dim; ++d)
          if (constraint.side[d] != none)
            velocity[d][constraint.node] =
                ruled_velocity<dim>(boundaries_[constraint.side[d]], d, velocity[d][constraint.node], x, state.time);
      }
    for (auto &component : velocity)
      mesh_.hang(component);
  }

  namespace
  {
    /// Area that each end of a straight edge carries, cm^2: half the length, or in axisymmetry 2 pi times the
    /// integral of the linear shape function and the radius.
    std::array<double, 2>
    end_areas(Symmetry symmetry, const std::array<double, 2> &r, double length)
    {
      if (symmetry == Symmetry::planar)
        return {0.5 * length, 0.5 * length};
      const double factor = std::numbers::pi / 3. * length;
      return {factor * (2. * r[0] + r[1]), factor * (r[0] + 2. * r[1])};
    }

    /// Share of the traction of a wave that acts, from its size and that of the force of the cell on the face.
    /// Material whose stress is small beside rho c v flies: its traction is at most its own force (any more would
    /// compress it, raise its stress and with it the traction). From a fifth of rho c v on it carries a wave.
    double
    absorbed_share(double absorbing, double available)
    {
      constexpr double flying = 0.1;
      if (available >= 2. * flying * absorbing)
        return 1.;
      const double ratio = available / absorbing;
      return ratio + std::max(0., ratio - flying) * (1. - 2. * flying) / flying;
    }
  } // namespace

  template <int dim>
  void
  NodeMotion<dim>::load_sides(const State<dim> &state, const Derived &derived, double dt, const StepWork<dim> &work)
  {
    for (const Index node : traction_node_)
      for (int d = 0; d < dim; ++d)
        traction_[d][node] = damping_[d][node] = 0;
    for (const LoadedFace &face : loaded_)
      {
        const Boundary<dim> &side = boundaries_[face.side];
        if (side.kind == BoundaryKind::pressure || side.keeps_ambient)
          press(face, side.pressure, state, work);
        if (side.kind == BoundaryKind::transmitting)
          absorb(face, state, derived, dt, work);
      }
  }

  template <int dim>
  typename NodeMotion<dim>::Edge
  NodeMotion<dim>::edge(const LoadedFace &face, const StepWork<dim> &work) const
  {
    Edge edge;
    for (int i = 0; i < 2; ++i)
      edge.node[i] = mesh_.cell_node[face.cell * 4 + face.corner[i]];
    const auto &x = work.half_position;
    for (int d = 0; d < dim; ++d)
      edge.along[d] = x[d][edge.node[1]] - x[d][edge.node[0]];
    edge.length = std::sqrt(edge.along[0] * edge.along[0] + edge.along[1] * edge.along[1]);
    edge.area   = end_areas(mesh_.symmetry, {x[0][edge.node[0]], x[0][edge.node[1]]}, edge.length);
    return edge;
  }

  template <int dim>
  void
  NodeMotion<dim>::press(const LoadedFace &face, double pressure, const State<dim> &state, const StepWork<dim> &work)
  {
    double material = 0;
    for (const MaterialState &m : state.material)
      material += m.volume[face.cell];
    const double p  = pressure * std::min(1., material / state.volume[face.cell]);
    const Edge   at = edge(face, work);
    if (at.length == 0)
      return;
    for (int i = 0; i < 2; ++i)
      {
        traction_[0][at.node[i]] -= p * at.area[i] * at.along[1] / at.length;
        traction_[1][at.node[i]] += p * at.area[i] * at.along[0] / at.length;
      }
  }

  template <int dim>
  void
  NodeMotion<dim>::absorb(const LoadedFace &face, const State<dim> &state, const Derived &derived, double dt,
                          const StepWork<dim> &work)
  {
    const Edge           at       = edge(face, work);
    const Boundary<dim> &side     = boundaries_[face.side];
    const int            axis     = face.side / 2;
    const double         outwards = face.side % 2 ? 1. : -1., area = at.area[0] + at.area[1];
    if (!(area > 0))
      return;
    SideContact contact{face.cell, axis, 0., state.volume[face.cell] / area, 0.};
    for (int i = 0; i < 2; ++i)
      {
        const Index opposite = mesh_.cell_node[face.cell * 4 + (face.corner[i] ^ (1 << axis))];
        contact.opening += 0.5 * outwards * (state.velocity[axis][at.node[i]] - state.velocity[axis][opposite]);
        contact.sliding += 0.5 * (state.velocity[1 - axis][at.node[i]] - side.velocity[1 - axis]);
      }
    contact.sliding         = std::abs(contact.sliding);
    const OutgoingWave wave = outgoing_wave(contact, beyond_[face.side], state, derived, dt, work);
    for (int d = 0; d < dim; ++d)
      {
        const double impedance = d == axis ? wave.normal : wave.tangential;
        const double at_rest   = (d == axis ? -outwards * wave.pressure : 0.) + impedance * side.velocity[d];
        double       absorbing = 0, available = 0;
        for (int i = 0; i < 2; ++i)
          {
            absorbing += std::abs((at_rest - impedance * state.velocity[d][at.node[i]]) * at.area[i]);
            available += work.corner_force[(face.cell * 4 + face.corner[i]) * dim + d];
          }
        const double share = side.keeps_ambient ? 1. : absorbed_share(absorbing, std::abs(available));
        for (int i = 0; i < 2; ++i)
          {
            traction_[d][at.node[i]] += share * at_rest * at.area[i];
            damping_[d][at.node[i]] += share * impedance * at.area[i];
          }
      }
  }

  template <int dim>
  void
  NodeMotion<dim>::sum_corner_forces(StepWork<dim> &work) const
  {
    const double *corner_force = work.corner_force.data();
    for (Index node = 0; node < mesh_.n_nodes; ++node)
      {
        Vector<dim> sum{};
        for (Index i = mesh_.node_corner_begin[node]; i < mesh_.node_corner_begin[node + 1]; ++i)
          for (int d = 0; d < dim; ++d)
            sum[d] += corner_force[mesh_.node_corner[i] * dim + d];
        for (int d = 0; d < dim; ++d)
          work.node_force[d][node] = sum[d];
      }
    for (auto &component : work.node_force)
      mesh_.share_out(component);
  }

  template <int dim>
  void
  NodeMotion<dim>::constrain(const State<dim> &state, double dt, StepWork<dim> &work,
                             BoundaryExchange<dim> &exchange) const
  {
    for (const ConstrainedNode &constraint : constrained_)
      {
        const Index node = constraint.node;
        Vector<dim> x; // at the end of the step, but for the change of velocity in it
        for (int d = 0; d < dim; ++d)
          x[d] = state.position[d][node] + dt * state.velocity[d][node];
        for (int d = 0; d < dim; ++d)
          if (constraint.side[d] != none)
            {
              const double before = state.velocity[d][node];
              const double after  = ruled_velocity<dim>(boundaries_[constraint.side[d]], d, before, x, state.time + dt);
              const double impulse   = state.node_mass[node] * (after - work.velocity[d][node]);
              work.velocity[d][node] = after;
              if (!constraint.owned || !(state.node_mass[node] > 0))
                continue;
              exchange.momentum[d] += impulse;
              exchange.work += impulse * 0.5 * (before + after);
            }
      }
  }

  template <int dim>
  void
  NodeMotion<dim>::keep_shapes(const State<dim> &state, std::span<const RigidFragment<dim>> rigid, StepWork<dim> &work,
                               BoundaryExchange<dim> &exchange) const
  {
    constexpr int corners = FlatMesh<dim>::corners;
    for (const RigidFragment<dim> &fragment : rigid)
      {
        const Index *node = &mesh_.cell_node[fragment.cell * corners];
        double       mass = 0;
        for (int k = 0; k < corners; ++k)
          mass += state.node_mass[node[k]];
        if (!(mass > 0))
          continue;
        for (int d = 0; d < dim; ++d)
          {
            const double before = state.velocity[d][node[0]];
            double       gained = 0; // momentum
            for (int k = 0; k < corners; ++k)
              gained += state.node_mass[node[k]] * (work.velocity[d][node[k]] - before);
            const double after = fragment.held[d] ? before : before + gained / mass;
            for (int k = 0; k < corners; ++k)
              work.velocity[d][node[k]] = after;
            if (!fragment.held[d] || fragment.cell >= mesh_.n_owned)
              continue;
            exchange.momentum[d] -= gained;
            exchange.work -= gained * before;
          }
      }
  }

  template <int dim>
  void
  NodeMotion<dim>::accelerate_loaded(const State<dim> &state, double dt, StepWork<dim> &work)
  {
    // implicit in the mean velocity: the traction then belongs to the same time as the forces of the cells
    for (const Index node : traction_node_)
      if (const double mass = state.node_mass[node]; mass > 0)
        for (int d = 0; d < dim; ++d)
          {
            const double v = state.velocity[d][node], drag = damping_[d][node];
            const double force     = work.node_force[d][node] + traction_[d][node];
            const double change    = dt * (force - drag * v) / (mass + 0.5 * dt * drag);
            work.velocity[d][node] = v + change;
            traction_[d][node] -= drag * (v + 0.5 * change);
          }
  }

  template <int dim>
  BoundaryExchange<dim>
  NodeMotion<dim>::move(const State<dim> &state, double dt, std::span<const RigidFragment<dim>> rigid,
                        StepWork<dim> &work)
  {
    sum_corner_forces(work);
    for (int d = 0; d < dim; ++d)
      {
        const double *force = work.node_force[d].data(), *mass = state.node_mass.data();
        const double *v    = state.velocity[d].data();
        double       *next = work.velocity[d].data();
        for (Index node = 0; node < mesh_.n_nodes; ++node)
          next[node] = mass[node] > 0 ? v[node] + dt * (force[node] / mass[node]) : v[node];
      }

    accelerate_loaded(state, dt, work);
    BoundaryExchange<dim> exchange;
    keep_shapes(state, rigid, work, exchange);
    constrain(state, dt, work, exchange);

    for (int d = 0; d < dim; ++d)
      {
        const double *x = state.position[d].data(), *v = state.velocity[d].data();
        double       *next = work.velocity[d].data(), *mean = work.mean_velocity[d].data();
        double       *position = work.position[d].data();
        for (Index node = 0; node < mesh_.n_nodes; ++node)
          {
            mean[node]     = 0.5 * (v[node] + next[node]);
            position[node] = x[node] + dt * mean[node];
          }
        for (auto *component : {&work.velocity[d], &work.mean_velocity[d], &work.position[d]})
          mesh_.hang(*component);
      }

    for (const Index node : traction_node_)
      if (node_owned_[node] && state.node_mass[node] > 0)
        for (int d = 0; d < dim; ++d)
          {
            exchange.momentum[d] += dt * traction_[d][node];
            exchange.work += dt * traction_[d][node] * work.mean_velocity[d][node];
          }
    return exchange;
  }

  template class NodeMotion<2>;
} // namespace whipple
