// SPDX-License-Identifier: LGPL-2.1-or-later
// Debris by angle, velocity and size of fragments on clouds whose answers are known.
#include "projection_fixture.h"
#include "source_directory.h"

#include <whipple/diagnostics/debris_spectrum.h>
#include <whipple/diagnostics/fragment_sizes.h>
#include <whipple/ledger/totals.h>
#include <whipple/run/resume.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  /// Fragments of one cell each, of the first material, at rest.
  struct Cloud
  {
    FlatMesh<2> mesh;
    State<2>    state;

    explicit Cloud(Symmetry symmetry, int roots = 4)
      : mesh(mesh_of(lattice(symmetry, roots, 0), uniform_keys(lattice(symmetry, roots, 0), 0), Cohesion::fragments))
      , state(blank_state(mesh))
    {
      for (Index c = 0; c < mesh.n_cells; ++c)
        {
          set_material(state.material[0], c, state.volume[c], 1.35, 0.002, 0.5);
          for (int k = 0; k < 4; ++k)
            state.node_mass[mesh.cell_node[4 * c + k]] += state.corner_weight[4 * c + k] * state.material[0].mass[c];
        }
    }

    void
    set_velocity(Index c, double across, double along)
    {
      for (int k = 0; k < 4; ++k)
        {
          state.velocity[0][mesh.cell_node[4 * c + k]] = across;
          state.velocity[1][mesh.cell_node[4 * c + k]] = along;
        }
    }
    double
    mass(Index c) const
    {
      return state.material[0].mass[c];
    }
  };

  ConservedTotals<2>
  sum(const Spectrum<2> &spectrum)
  {
    ConservedTotals<2> all;
    for (const ConservedTotals<2> &bin : spectrum.bin)
      all += bin;
    return all;
  }

  TEST(DebrisSpectrum, EachElementIsInTheBinOfItsAngle)
  {
    Cloud cloud(Symmetry::axisymmetric, 2);
    // 12, 77, 103 and 180 degrees at 0.5 cm/us
    const std::array<double, 4> degrees{{12., 77., 103., 180.}};
    for (Index c = 0; c < 4; ++c)
      cloud.set_velocity(c, 0.5 * std::sin(degrees[c] * std::numbers::pi / 180.),
                         0.5 * std::cos(degrees[c] * std::numbers::pi / 180.));
    const Spectrum<2> s =
        spectrum<2>(cloud.mesh, cloud.state, equal_edges(0., 180., 36), flight_angle<2>, MPI_COMM_SELF);
    ASSERT_EQ(s.bin.size(), 36u);
    EXPECT_EQ(s.edges[15], 75.);
    for (Index c = 0; c < 4; ++c)
      {
        const ConservedTotals<2> &bin = s.bin[std::array<int, 4>{{2, 15, 20, 35}}[c]];
        EXPECT_DOUBLE_EQ(bin.mass, cloud.mass(c)) << c;
        EXPECT_NEAR(bin.momentum[1], cloud.mass(c) * 0.5 * std::cos(degrees[c] * std::numbers::pi / 180.),
                    1e-15 * cloud.mass(c))
            << c;
        EXPECT_NEAR(bin.kinetic_energy, 0.125 * cloud.mass(c), 1e-15 * cloud.mass(c)) << c;
        EXPECT_DOUBLE_EQ(bin.internal_energy, 0.002 * cloud.mass(c)) << c;
      }
  }

  TEST(DebrisSpectrum, VelocityBinsHoldTheFastestAndTheSlowest)
  {
    Cloud cloud(Symmetry::planar, 2);
    for (Index c = 0; c < 4; ++c)
      cloud.set_velocity(c, 0., std::array<double, 4>{{-0.031, 0.2, 0.61, 0.659}}[c]);
    const auto edges = velocity_edges(cloud.mesh, cloud.state, 0.02, MPI_COMM_SELF);
    ASSERT_EQ(edges.size(), 36u); // -0.04 to 0.66
    EXPECT_DOUBLE_EQ(edges.front(), -0.04);
    EXPECT_DOUBLE_EQ(edges.back(), 0.66);
    const Spectrum<2> s = spectrum<2>(cloud.mesh, cloud.state, edges, axial_velocity<2>, MPI_COMM_SELF);
    EXPECT_DOUBLE_EQ(s.bin[0].mass, cloud.mass(0));
    EXPECT_DOUBLE_EQ(s.bin[32].mass, cloud.mass(2)); // 0.60 to 0.62
    EXPECT_DOUBLE_EQ(s.bin[34].mass, cloud.mass(3)); // 0.64 to 0.66
    // bins that would be too many are wider
    EXPECT_LE(velocity_edges(cloud.mesh, cloud.state, 1e-4, MPI_COMM_SELF).size(), 65u);
    // nothing moves
    EXPECT_EQ(velocity_edges(Cloud(Symmetry::planar).mesh, Cloud(Symmetry::planar).state, 0.02, MPI_COMM_SELF),
              (std::vector<double>{0., 0.02}));
  }

  TEST(DebrisSpectrum, BinsAddUpToTheTotals)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      for (const Cohesion cohesion : {Cohesion::fragments, Cohesion::bonded})
        {
          const Lattice<2>  grid  = lattice(symmetry, 6, 1);
          const FlatMesh<2> mesh  = mesh_of(grid, hanging_keys(grid), cohesion);
          State<2>          state = blank_state(mesh);
          Random            random(7);
          fill_randomly(state, random);
          set_velocities(mesh, state, 0.7, random); // in all directions
          const auto all = totals(mesh, state, MPI_COMM_SELF);
          for (const auto &[edges, quantity] :
               {std::pair(equal_edges(0., 180., 36), CellQuantity<2>(flight_angle<2>)),
                std::pair(velocity_edges(mesh, state, 0.03, MPI_COMM_SELF), CellQuantity<2>(axial_velocity<2>))})
            {
              const ConservedTotals<2> s = sum(spectrum<2>(mesh, state, edges, quantity, MPI_COMM_SELF));
              EXPECT_NEAR(s.mass, all.mass, 1e-14 * all.mass);
              EXPECT_NEAR(s.momentum[1], all.momentum[1], 1e-14 * all.mass);
              EXPECT_NEAR(s.kinetic_energy, all.kinetic_energy, 1e-13 * all.kinetic_energy);
              EXPECT_NEAR(s.internal_energy, all.internal_energy, 1e-14 * all.internal_energy);
            }
        }
  }

  /// Elements that wait outside the mesh count as if they were on it.
  TEST(DebrisSpectrum, WhatWaitsCounts)
  {
    Cloud cloud(Symmetry::axisymmetric, 2);
    for (Index c = 0; c < 4; ++c)
      cloud.set_velocity(c, 0.02 * c, 0.5);
    const auto       layout = CellPacketLayout<2>::of(cloud.state);
    const auto       edges  = equal_edges(0., 180., 36);
    WaitingDebris<2> waiting;
    waiting.parts           = begin_to_wait(layout, {}, elements_of(layout, cloud.mesh, cloud.state), {}, 0.);
    const Spectrum<2> there = spectrum<2>(cloud.mesh, cloud.state, edges, flight_angle<2>, MPI_COMM_SELF);
    const Spectrum<2> twice = spectrum<2>(cloud.mesh, cloud.state, edges, flight_angle<2>, MPI_COMM_SELF, &waiting);
    EXPECT_GT(there.bin[0].mass, 0.);
    for (std::size_t b = 0; b < edges.size() - 1; ++b)
      {
        EXPECT_DOUBLE_EQ(twice.bin[b].mass, 2. * there.bin[b].mass);
        EXPECT_DOUBLE_EQ(twice.bin[b].kinetic_energy, 2. * there.bin[b].kinetic_energy);
      }

    FieldLayout fields;
    fields.fields = {{"fragmented share", "1", Carrier::mass}, {"fragment size moment", "cm", Carrier::mass}};
    for (auto &part : waiting.parts)
      {
        part.element.packet[layout.field(0, 0)] = 1.;
        part.element.packet[layout.field(0, 1)] = 0.05;
      }
    for (Field &field : cloud.state.material[0].fields)
      std::fill(field.value.begin(), field.value.end(), 0.);
    const auto sizes = measure_fragments(fields, cloud.mesh, cloud.state, MPI_COMM_SELF, &waiting);
    ASSERT_TRUE(sizes);
    double mass = 0;
    for (Index c = 0; c < 4; ++c)
      mass += cloud.mass(c);
    EXPECT_NEAR(sizes->unbroken_mass, mass, 1e-14 * mass); // those on the mesh
    EXPECT_NEAR(sizes->number, mass / (2.7 * 125e-6), 1e-12 * mass / (2.7 * 125e-6));
  }

  /// The lists in summary.json of a run: each adds up to what the stage has in all.
  TEST(DebrisSpectrum, ListsOfARunAddUp)
  {
    std::filesystem::create_directories("debris_output");
    const Problem<2> problem    = read_problem<2>(source_directory() + "/prm/whipple_shield.prm",
                                               {"Mesh/Finest cell = 0.032 cm", "Output/Fields interval = none",
                                                   "Stages/List = perforation, debris", "Stages/perforation/End = 0.7 us",
                                                   "Stages/debris/End = for 0.5 us"});
    const auto       simulation = start(problem, {"debris_output/run"}, EarlierRun::replaced, MPI_COMM_SELF);
    simulation->run();
    const ResultTable &results = simulation->summary().results.at("debris");
    for (const char *by : {"angle", "velocity"})
      for (const auto &[quantity, unit] :
           {std::pair("mass", "g"), std::pair("axial_momentum", "g_cm_per_us"), std::pair("kinetic_energy", "Mbar_cm3"),
            std::pair("internal_energy", "Mbar_cm3")})
        {
          const double all = std::get<double>(results.at(std::string(quantity) + '_' + unit));
          const auto  &list =
              std::get<std::vector<double>>(results.at(std::string(quantity) + "_by_" + by + '_' + unit));
          EXPECT_GT(all, 0.);
          EXPECT_NEAR(std::accumulate(list.begin(), list.end(), 0.), all, 1e-13 * all) << quantity << by;
        }
    EXPECT_EQ(results.at("melt_share"), summary::Result(std::monostate{})); // melting is off
    EXPECT_EQ(results.at("fragment_number"), summary::Result(std::monostate{}));
  }

  TEST(FragmentSizes, CubesOfTheSizeThatIsCarried)
  {
    Cloud       cloud(Symmetry::planar, 2);
    FieldLayout layout;
    layout.fields = {{"fragmented share", "1", Carrier::mass}, {"fragment size moment", "cm", Carrier::mass}};
    auto &share = cloud.state.material[0].fields[0].value, &moment = cloud.state.material[0].fields[1].value;
    for (auto *field : {&share, &moment})
      std::fill(field->begin(), field->end(), 0.);
    EXPECT_FALSE(measure_fragments(layout, cloud.mesh, cloud.state, MPI_COMM_SELF)); // all whole

    share            = {1., 0.25, 0., 1.}; // sizes 0.05, 0.04 and 0.003 cm; 0.0312 to 0.0625 is one bin
    moment           = {0.05, 0.01, 0., 0.003};
    const auto sizes = measure_fragments(layout, cloud.mesh, cloud.state, MPI_COMM_SELF);
    ASSERT_TRUE(sizes);
    const double m = cloud.mass(0), cube = 2.7 * 1e-6; // all cells are alike; true density 2.7
    EXPECT_NEAR(sizes->unbroken_mass, 1.75 * m, 1e-14 * m);
    EXPECT_NEAR(sizes->mean_size, (0.05 + 0.25 * 0.04 + 0.003) / 2.25, 1e-14);
    const double large = m / (cube * 125.) + 0.25 * m / (cube * 64.), small = m / (cube * 0.027);
    EXPECT_NEAR(sizes->number, large + small, 1e-13 * small);
    ASSERT_EQ(sizes->edges.size(), 6u); // 2^-9 to 2^-4
    EXPECT_EQ(sizes->edges.front(), 1. / 512);
    EXPECT_EQ(sizes->edges.back(), 1. / 16);
    EXPECT_NEAR(sizes->mass[4], 1.25 * m, 1e-14 * m);
    EXPECT_NEAR(sizes->number_of_bin[0], small, 1e-13 * small);
    EXPECT_NEAR(std::accumulate(sizes->mass.begin(), sizes->mass.end(), 0.) + sizes->unbroken_mass, 4. * m, 1e-14 * m);
  }
} // namespace
