// SPDX-License-Identifier: LGPL-2.1-or-later
// What passes the plane before a plate: uniform flow by formula, and a plane slug that gives a target all it has.
#include "projection_fixture.h"
#include "source_directory.h"

#include <whipple/diagnostics/plate_load.h>
#include <whipple/ledger/totals.h>
#include <whipple/run/resume.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numeric>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  double
  sum(const std::vector<double> &list)
  {
    return std::accumulate(list.begin(), list.end(), 0.);
  }

  TEST(PlateLoad, UniformFlow)
  {
    constexpr double density = 1.35, energy = 0.002, across = 0.1, along = 0.6, pressure = 0.01, dt = 0.02;
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        const Lattice<2>  grid  = lattice(symmetry, 4, 1);
        const FlatMesh<2> mesh  = mesh_of(grid, hanging_keys(grid));
        State<2>          state = blank_state(mesh);
        for (Index c = 0; c < mesh.n_cells; ++c)
          set_material(state.material[0], c, state.volume[c], density, energy, 0.5);
        for (Index n = 0; n < mesh.n_nodes; ++n)
          {
            state.velocity[0][n] = across;
            state.velocity[1][n] = along;
          }
        state.index.stress = {{1, 1, 1}};
        std::fill(state.material[0].fields[1].value.begin(), state.material[0].fields[1].value.end(), -0.004);
        Derived derived;
        derived.material.resize(2);
        for (DerivedMaterial &m : derived.material)
          m.pressure.assign(mesh.n_cells, pressure);
        // bins that do not fit the cells; the second material is nowhere
        const LoadSite site{symmetry, -0.07, 0.1, {0., 0.13, 0.26, 0.4}};
        const auto     load = load_of_step(site, mesh, state, derived, dt, MPI_COMM_SELF);
        for (std::size_t b = 0; b < 3; ++b)
          {
            const double from = site.edges[b], to = site.edges[b + 1];
            const double area = symmetry == Symmetry::planar ? to - from : std::numbers::pi * (to * to - from * from);
            const double mass = density * along * area * dt, push = pressure + 0.5 * 0.004;
            const double work = push * along + 0.5 * 0.004 * across;
            EXPECT_NEAR(load.mass[b], mass, 1e-14 * mass);
            EXPECT_NEAR(load.momentum[b], mass * along + push * area * dt, 1e-14 * mass);
            EXPECT_NEAR(load.energy[b], mass * (energy + 0.5 * (across * across + along * along)) + work * area * dt,
                        1e-14 * mass);
          }
      }
  }

  /// Squares of 0.1 cm in two rows, their middles at z = -0.25 and -0.15, fly through z = -0.099 with 0.5 cm/us: the
  /// upper row at 0.102 us, the lower at 0.302 us, each once.
  TEST(PlateLoad, WhatWaitsPassesWhole)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        const Lattice<2>  grid  = lattice(symmetry, 2, 0);
        const FlatMesh<2> mesh  = mesh_of(grid, uniform_keys(grid, 0), Cohesion::fragments);
        State<2>          state = blank_state(mesh);
        for (Index c = 0; c < 4; ++c)
          set_material(state.material[0], c, state.volume[c], 1.35, 0.002, 0.5);
        std::fill(state.velocity[1].begin(), state.velocity[1].end(), 0.5);
        const auto       layout = CellPacketLayout<2>::of(state);
        WaitingDebris<2> waiting;
        waiting.parts = begin_to_wait(layout, {}, elements_of(layout, mesh, state), {}, 0.);
        const LoadSite site{symmetry, -0.099, 0.1, {0., 0.1, 0.2}};
        PlateLoad      load(2);
        for (int step = 0; step < 25; ++step)
          {
            EXPECT_EQ(sum(load.mass) > 0, step > 5) << step;
            load += load_of_waiting(site, layout, waiting, 0.02 * step, 0.02 * (step + 1));
          }
        for (int b = 0; b < 2; ++b) // two squares of each column
          {
            const double mass = 2. * 1.35 * 0.1 * site.area(0.1 * b, 0.1 * (b + 1));
            EXPECT_NEAR(load.mass[b], mass, 1e-13 * mass);
            EXPECT_NEAR(load.momentum[b], 0.5 * mass, 1e-13 * mass);
            EXPECT_NEAR(load.energy[b], (0.002 + 0.125) * mass, 1e-13 * mass);
          }
      }
  }

  /// A flyer of 5 mm at 0.08 cm/us comes to rest on a thicker target of the same metal: its momentum per area is
  /// rho d v = 2.785 * 0.5 * 0.08 = 0.1114 Mbar us, its energy half of that times v. The target is 0.2 cm away.
  TEST(PlateLoad, PlaneSlugGivesItsMomentum)
  {
    std::filesystem::create_directories("load_output");
    const Problem<2> problem = read_problem<2>(source_directory() + "/prm/verification/flying_plate.prm",
                                               {"Exact solution/Name = none", "Bodies/flyer/Front face = -0.7 cm",
                                                "Geometry/Lower corner = 0 cm, -1.2 cm", "Stages/impact/End = 7 us"});
    ASSERT_EQ(loaded_plate(problem.scene), std::optional<std::size_t>(1));
    const auto simulation = start(problem, {"load_output/run"}, EarlierRun::replaced, MPI_COMM_SELF);
    simulation->run();
    const ResultTable &results = simulation->summary().results.at("target");
    // but for what has not passed the plane: the flyer's rear is there, at rest and a little warm
    const FlatMesh<2> &mesh  = simulation->domain().view->mesh;
    const double       plane = std::get<double>(results.at("load_plane_cm"));
    const auto         rest  = cell_sum<2>(
        mesh, simulation->domain().state, [&](Index c) { return mesh.lower[1][c] < plane - 1e-9; }, MPI_COMM_SELF);
    const double expected        = 2.785 * 0.5 * 0.08 - rest.momentum[1] / 0.08;
    const double expected_energy = 0.5 * 0.08 * 2.785 * 0.5 * 0.08 - rest.total_energy() / 0.08;
    EXPECT_NEAR(expected, 2.785 * 0.5 * 0.08, 0.01 * expected); // it is at rest
    const auto &edges   = std::get<std::vector<double>>(results.at("load_by_place_edges_cm"));
    const auto &impulse = std::get<std::vector<double>>(results.at("impulse_by_place_Mbar_us"));
    const auto &energy  = std::get<std::vector<double>>(results.at("delivered_energy_by_place_Mbar_cm"));
    ASSERT_EQ(edges.size(), impulse.size() + 1);
    for (std::size_t b = 0; b < impulse.size(); ++b)
      {
        EXPECT_NEAR(impulse[b], expected, 0.005 * expected) << b;
        EXPECT_NEAR(energy[b], expected_energy, 0.005 * expected_energy) << b;
      }
    EXPECT_NEAR(std::get<double>(results.at("impulse_g_cm_per_us")), sum(impulse) * 0.08 / impulse.size(), 1e-14);
  }
} // namespace
