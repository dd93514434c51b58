// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/lagrange_step.h>
#include <whipple/mesh/flat_builder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <random>

/// A mesh, a state and a Lagrange step without stages: what the tests of the hydro room run.
namespace whipple::hydro_case
{
  /// All cells of the box at the lattice's finest level.
  inline std::vector<CellKey>
  uniform_keys(const Lattice<2> &lattice)
  {
    std::vector<CellKey> keys;
    for (int j = 0; j < lattice.finest(1); ++j)
      for (int i = 0; i < lattice.finest(0); ++i)
        keys.push_back(make_key<2>(lattice.max_level, {{i, j}}));
    return keys;
  }

  /// Root cells of the box; those for which `fine(i, j)` holds are split once. Needs max_level = 1.
  inline std::vector<CellKey>
  two_level_keys(const Lattice<2> &lattice, const std::function<bool(int, int)> &fine)
  {
    std::vector<CellKey> keys;
    for (int j = 0; j < lattice.roots[1]; ++j)
      for (int i = 0; i < lattice.roots[0]; ++i)
        if (fine(i, j))
          for (int child = 0; child < 4; ++child)
            keys.push_back(make_key<2>(1, {{2 * i + (child & 1), 2 * j + (child >> 1)}}));
        else
          keys.push_back(make_key<2>(0, {{2 * i, 2 * j}}));
    return keys;
  }

  inline FlatMesh<2>
  build(const Lattice<2> &lattice, const std::vector<CellKey> &keys, Cohesion cohesion = Cohesion::bonded)
  {
    return build_flat_mesh<2>(lattice, keys, static_cast<Index>(keys.size()), std::vector<std::uint8_t>(keys.size(), 0),
                              0, cohesion);
  }

  inline Boundaries<2>
  sides(BoundaryKind kind)
  {
    Boundaries<2> boundaries;
    for (auto &boundary : boundaries)
      boundary.kind = kind;
    return boundaries;
  }

  /// State on the undeformed mesh: at rest, every cell empty; all fields allocated.
  inline State<2>
  make_state(const FlatMesh<2> &mesh, const std::vector<Material> &materials)
  {
    State<2> state;
    state.position = mesh.node_point;
    for (auto &component : state.velocity)
      component.assign(mesh.n_nodes, 0.);
    initialise_geometry(mesh, state);
    bool strength = false;
    for (const Material &material : materials)
      strength = strength || material.strength;
    for (const Material &material : materials)
      {
        MaterialState &m = state.material.emplace_back();
        for (auto *array : {&m.volume, &m.mass, &m.density, &m.energy})
          array->assign(mesh.n_cells, 0.);
        if (material.void_law)
          m.void_fraction.assign(mesh.n_cells, 0.);
        if (strength)
          for (const char *name : {"stress 00", "stress 11", "stress 01", "plastic strain"})
            m.fields.push_back({{name, "", Carrier::volume}, std::vector<double>(mesh.n_cells, 0.)});
      }
    if (strength)
      state.index = {0, 1, 2, 3};
    return state;
  }

  /// Fill a share of a cell with a material of bulk density rho and specific energy e.
  inline void
  fill(State<2> &state, Index cell, double density, double energy, std::size_t material = 0, double share = 1.)
  {
    MaterialState &m = state.material[material];
    m.volume[cell]   = share == 1. ? state.volume[cell] : share * state.volume[cell];
    m.density[cell]  = density;
    m.mass[cell]     = density * m.volume[cell];
    m.energy[cell]   = energy;
  }

  inline void
  fill_all(State<2> &state, double density, double energy, std::size_t material = 0)
  {
    for (Index cell = 0; cell < state.n_cells(); ++cell)
      fill(state, cell, density, energy, material);
  }

  /// Hanging nodes to the mean of their masters.
  inline void
  constrain(const FlatMesh<2> &mesh, std::array<std::vector<double>, 2> &field)
  {
    for (std::size_t h = 0; h < mesh.hanging.size(); ++h)
      for (auto &component : field)
        component[mesh.hanging[h]] = 0.5 * (component[mesh.master[h][0]] + component[mesh.master[h][1]]);
  }

  /// Give every node the velocity of a function of its position.
  inline void
  set_velocity(const FlatMesh<2> &mesh, State<2> &state, const std::function<Vector<2>(double, double)> &velocity)
  {
    for (Index node = 0; node < mesh.n_nodes; ++node)
      {
        const Vector<2> v = velocity(state.position[0][node], state.position[1][node]);
        for (int d = 0; d < 2; ++d)
          state.velocity[d][node] = v[d];
      }
    constrain(mesh, state.velocity);
  }

  /// Mass, momentum and energy of the whole, with the sizes of their terms to measure round-off against.
  struct Totals
  {
    double    mass = 0, energy = 0, internal = 0;
    Vector<2> momentum{}, momentum_size{};
  };

  inline Totals
  totals(const State<2> &state)
  {
    Totals sum;
    for (const MaterialState &m : state.material)
      for (Index cell = 0; cell < state.n_cells(); ++cell)
        {
          sum.mass += m.mass[cell];
          sum.internal += m.mass[cell] * m.energy[cell];
        }
    sum.energy = sum.internal;
    for (Index node = 0; node < state.n_nodes(); ++node)
      for (int d = 0; d < 2; ++d)
        {
          const double p = state.node_mass[node] * state.velocity[d][node];
          sum.momentum[d] += p;
          sum.momentum_size[d] += std::abs(p);
          sum.energy += 0.5 * p * state.velocity[d][node];
        }
    return sum;
  }

  /// What follows from a state.
  inline Derived
  evaluate(LagrangeStep<2> &step, const State<2> &state)
  {
    Derived derived;
    step.evaluate(state, derived);
    return derived;
  }

  inline TimeStepLimit
  time_step(LagrangeStep<2> &step, const State<2> &state)
  {
    return step.time_step(state, evaluate(step, state));
  }

  inline LagrangeSums<2>
  advance(LagrangeStep<2> &step, State<2> &state, double dt)
  {
    return step.advance(state, evaluate(step, state), dt);
  }

  /// Run to `end`, at most growing dt by a tenth a step.
  /// @param first_step part of the stable time step to start with
  /// @return boundary work and all that steps report
  inline LagrangeSums<2>
  run(LagrangeStep<2> &step, State<2> &state, double end, double first_step = 0.01)
  {
    step.update_node_mass(state);
    Derived         derived = evaluate(step, state);
    LagrangeSums<2> total;
    double          dt = first_step * step.time_step(state, derived).dt / 1.1;
    while (end - state.time > 1e-12 * end)
      {
        dt                = std::min({1.1 * dt, step.time_step(state, derived).dt, end - state.time});
        const auto report = step.advance(state, derived, dt);
        step.evaluate(state, derived);
        total.viscous_work += report.viscous_work;
        total.hourglass_work += report.hourglass_work;
        total.plastic_work += report.plastic_work;
        total.boundary_work += report.boundary_work;
        for (int d = 0; d < 2; ++d)
          total.boundary_momentum[d] += report.boundary_momentum[d];
      }
    return total;
  }
} // namespace whipple::hydro_case
