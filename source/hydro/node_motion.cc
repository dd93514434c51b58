// SPDX-License-Identifier: LGPL-2.1-or-later

#include <whipple/hydro/node_motion.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace whipple
{
  template <int dim>
  NodeMotion<dim>::NodeMotion(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries)
    : mesh_(mesh)
    , node_owned_(mesh.n_nodes)
  {
    for (Index node = 0; node < mesh.n_nodes; ++node)
      {
        const Index begin = mesh.node_corner_begin[node], end = mesh.node_corner_begin[node + 1];
        node_owned_[node] = begin < end && mesh.node_corner[begin] / FlatMesh<dim>::corners < mesh.n_owned;
      }
    for (Index node = 0; node < mesh.n_nodes; ++node)
      {
        ConstrainedNode constraint{node, node_owned_[node] != 0, {}, {}};
        for (const BoundaryKind kind : {BoundaryKind::inflow, BoundaryKind::reflecting})
          for (int side = 0; side < 2 * dim; ++side)
            if ((mesh.node_side[node] >> side & 1) && boundaries[side].kind == kind)
              for (int d = 0; d < dim; ++d)
                if (kind == BoundaryKind::inflow || d == side / 2)
                  {
                    constraint.fixed[d]    = true;
                    constraint.velocity[d] = kind == BoundaryKind::inflow ? boundaries[side].velocity[d] : 0.;
                  }
        if (std::find(constraint.fixed.begin(), constraint.fixed.end(), true) != constraint.fixed.end())
          constrained_.push_back(constraint);
      }
    for (int axis = 0; axis < dim; ++axis)
      for (Index face = 0; face < mesh.faces[axis].size(); ++face)
        {
          const int side = mesh.faces[axis].side[face];
          if (side < 0 || boundaries[side].kind != BoundaryKind::transmitting)
            continue;
          const bool  upper = side % 2 == 1;
          const Index cell  = mesh.faces[axis].cell[upper ? 0 : 1][face];
          const int   low   = upper ? 1 << axis : 0;
          absorbing_.push_back({cell, axis, {low, low | (1 << (1 - axis))}});
          for (const int k : absorbing_.back().corner)
            traction_node_.push_back(mesh.cell_node[cell * 4 + k]);
        }
    std::sort(traction_node_.begin(), traction_node_.end());
    traction_node_.erase(std::unique(traction_node_.begin(), traction_node_.end()), traction_node_.end());
    if (!absorbing_.empty())
      for (auto &component : traction_)
        component.assign(mesh.n_nodes, 0.);
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

    /// Longitudinal and shear wave impedance of a cell, g/(cm^2 us), weighted by the share of the cell that
    /// each material takes.
    template <int dim>
    std::array<double, 2>
    impedances(const State<dim> &state, const StepWork<dim> &work, Index cell)
    {
      std::array<double, 2> sum{};
      for (std::size_t m = 0; m < state.material.size(); ++m)
        {
          const MaterialState &material = state.material[m];
          if (!(material.volume[cell] > 0))
            continue;
          const double share = material.volume[cell] / state.volume[cell], density = material.density[cell];
          const double c2    = material.sound_speed[cell] * material.sound_speed[cell];
          double       shear = 0;
          if (!work.material[m].shear_modulus.empty())
            shear = work.material[m].shear_modulus[cell] *
                    (material.has_voids() ? 1. - material.void_fraction[cell] : 1.) / density;
          sum[0] += share * density * std::sqrt(c2 + 4. / 3. * shear);
          sum[1] += share * density * std::sqrt(shear);
        }
      return sum;
    }
    /// Share of the Lysmer traction that acts, from its size and that of the force of the cell on the face.
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
  NodeMotion<dim>::absorb(const State<dim> &state, const StepWork<dim> &work)
  {
    for (const Index node : traction_node_)
      for (auto &component : traction_)
        component[node] = 0;
    for (const AbsorbingFace &face : absorbing_)
      {
        const std::array<Index, 2> node{mesh_.cell_node[face.cell * 4 + face.corner[0]],
                                        mesh_.cell_node[face.cell * 4 + face.corner[1]]};
        const auto                &x  = work.half_position;
        const double               dr = x[0][node[1]] - x[0][node[0]], dz = x[1][node[1]] - x[1][node[0]];
        const auto area      = end_areas(mesh_.symmetry, {x[0][node[0]], x[0][node[1]]}, std::sqrt(dr * dr + dz * dz));
        const auto impedance = impedances(state, work, face.cell);
        for (int d = 0; d < dim; ++d)
          {
            std::array<double, 2> force;
            double                absorbing = 0, available = 0;
            for (int i = 0; i < 2; ++i)
              {
                force[i] = -impedance[d == face.axis ? 0 : 1] * area[i] * state.velocity[d][node[i]];
                absorbing += std::abs(force[i]);
                available += work.corner_force[(face.cell * 4 + face.corner[i]) * dim + d];
              }
            const double share = absorbed_share(absorbing, std::abs(available));
            for (int i = 0; i < 2; ++i)
              traction_[d][node[i]] += share * force[i];
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
    for (std::size_t i = 0; i < mesh_.hanging.size(); ++i)
      for (auto &component : work.node_force)
        for (const Index master : mesh_.master[i])
          component[master] += 0.5 * component[mesh_.hanging[i]];
  }

  template <int dim>
  BoundaryExchange<dim>
  NodeMotion<dim>::move(const State<dim> &state, double dt, StepWork<dim> &work) const
  {
    sum_corner_forces(work);
    for (const Index node : traction_node_)
      for (int d = 0; d < dim; ++d)
        work.node_force[d][node] += traction_[d][node];

    for (int d = 0; d < dim; ++d)
      {
        const double *force = work.node_force[d].data(), *mass = state.node_mass.data();
        const double *v    = state.velocity[d].data();
        double       *next = work.velocity[d].data();
        for (Index node = 0; node < mesh_.n_nodes; ++node)
          next[node] = mass[node] > 0 ? v[node] + dt * (force[node] / mass[node]) : v[node];
      }

    BoundaryExchange<dim> exchange;
    for (const ConstrainedNode &constraint : constrained_)
      for (int d = 0; d < dim; ++d)
        if (constraint.fixed[d])
          {
            const Index  node      = constraint.node;
            const double impulse   = state.node_mass[node] * (constraint.velocity[d] - work.velocity[d][node]);
            work.velocity[d][node] = constraint.velocity[d];
            if (!constraint.owned || !(state.node_mass[node] > 0))
              continue;
            exchange.momentum[d] += impulse;
            exchange.work += impulse * 0.5 * (state.velocity[d][node] + constraint.velocity[d]);
          }

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
        for (std::size_t i = 0; i < mesh_.hanging.size(); ++i)
          {
            const Index node = mesh_.hanging[i], a = mesh_.master[i][0], b = mesh_.master[i][1];
            next[node]     = 0.5 * (next[a] + next[b]);
            mean[node]     = 0.5 * (mean[a] + mean[b]);
            position[node] = 0.5 * (position[a] + position[b]);
          }
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
