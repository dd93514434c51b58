// SPDX-License-Identifier: LGPL-2.1-or-later
#include "remap_case.h"

#include <gtest/gtest.h>

#include <numbers>

namespace
{
  using namespace remap_case;
  using whipple::BoundaryKind;

  constexpr double radius = 0.35;

  double
  bump(const Point &x, const Point &centre)
  {
    const double s = std::hypot(x[0] - centre[0], x[1] - centre[1]) / radius;
    return 1. + (s < 1. ? std::pow(std::cos(0.5 * std::numbers::pi * s), 4) : 0.);
  }

  void
  fill_bump(const Mesh &mesh, State<2> &state, const Point &centre)
  {
    whipple::MaterialState &m = state.material[0];
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        double mean = 0;
        for (int i = 0; i < 64; ++i)
          mean += bump({mesh.lower[0][c] + (i % 8 + 0.5) / 8. * mesh.size[c],
                        mesh.lower[1][c] + (i / 8 + 0.5) / 8. * mesh.size[c]},
                       centre) /
                  64.;
        m.volume[c]  = state.volume[c];
        m.density[c] = mean;
        m.mass[c]    = mean * m.volume[c];
        m.energy[c]  = mean;
      }
  }

  struct Errors
  {
    double density, velocity; ///< L1
  };

  /// Density and velocity after half a unit of oblique flight at Courant number 0.3. The mesh moves with a uniform
  /// velocity whatever the nodes carry: density and velocity are advected alike.
  Errors
  advection_errors(const int n, const bool second_order)
  {
    const Mesh               mesh = uniform_mesh(Symmetry::planar, 1. / n, {n * 3 / 2, n * 5 / 4});
    whipple::RemapParameters parameters;
    parameters.second_order            = second_order;
    const whipple::Boundaries<2> sides = boundaries(BoundaryKind::transmitting);
    whipple::DirectionalRemap<2> remap(mesh, sides, parameters);
    State<2>                     state = empty_state(mesh, 1), exact = state;
    const Point                  v{1., 0.5}, start{0.45, 0.45}, end{0.95, 0.7};
    fill_bump(mesh, state, start);
    fill_bump(mesh, exact, end);
    for (Index k = 0; k < mesh.n_nodes; ++k)
      {
        const Point x{mesh.node_point[0][k], mesh.node_point[1][k]};
        state.velocity[0][k] = bump(x, start);
        exact.velocity[0][k] = bump(x, end);
      }
    lump(mesh, state);
    const int    steps = static_cast<int>(std::ceil(0.5 * n / 0.3));
    const double dt    = 0.5 / steps;
    for (int step = 0; step < steps; ++step)
      {
        for (int d = 0; d < 2; ++d)
          for (Index k = 0; k < mesh.n_nodes; ++k)
            state.position[d][k] = mesh.node_point[d][k] + dt * v[d];
        for (Index c = 0; c < mesh.n_cells; ++c)
          state.volume[c] = cell_volume(mesh, state, c);
        state.material[0].volume = state.volume; // full cells stay full
        remap_case::remap(remap, state, step % 2);
      }
    Errors error{};
    for (Index c = 0; c < mesh.n_cells; ++c)
      error.density += std::abs(state.material[0].density[c] - exact.material[0].density[c]) * state.volume[c];
    for (Index k = 0; k < mesh.n_nodes; ++k)
      error.velocity += std::abs(state.velocity[0][k] - exact.velocity[0][k]) * state.volume[0];
    return error;
  }
} // namespace

TEST(RemapOrder, SmoothFieldsAreSecondOrder)
{
  const Errors middle = advection_errors(64, true);
  const Errors fine = advection_errors(128, true), first = advection_errors(64, false);
  const double density_order  = std::log2(middle.density / fine.density);
  const double velocity_order = std::log2(middle.velocity / fine.velocity);
  RecordProperty("density_order", std::to_string(density_order));
  RecordProperty("velocity_order", std::to_string(velocity_order));
  EXPECT_GE(density_order, 1.9);
  EXPECT_GE(velocity_order, 1.9);
  EXPECT_GT(first.density, 5. * middle.density);
  EXPECT_GT(first.velocity, 5. * middle.velocity);
}

TEST(RemapUniform, StaysUniformToTheLastBit)
{
  // everything uniform but the mesh and its motion: a shear and a stretch across levels, full and void cells
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    {
      const Mesh             mesh  = graded_mesh({symmetry, {0., 0.}, 1. / 32., {4, 8}, 3},
                                                 [](const Point &x) { return std::hypot(x[0], x[1] - 0.6); });
      whipple::Boundaries<2> sides = boundaries(BoundaryKind::transmitting);
      const bool             axis  = symmetry == Symmetry::axisymmetric;
      sides[0].kind                = axis ? BoundaryKind::reflecting : BoundaryKind::transmitting;
      const Point                  uniform{axis ? 0. : 0.1, 1.1};
      whipple::DirectionalRemap<2> remap(mesh, sides, {});
      State<2>                     state = empty_state(mesh, 1);
      whipple::MaterialState      &m     = state.material[0];
      for (int step = 0; step < 20; ++step)
        {
          for (Index n = 0; n < mesh.n_nodes; ++n)
            {
              state.velocity[0][n] = 0.3 * mesh.node_point[0][n] * std::sin(3. * mesh.node_point[1][n] + step);
              state.velocity[1][n] = 0.7 + 0.2 * mesh.node_point[0][n];
            }
          lump(mesh, state);
          const auto full = [&](const Index c) {
            return step == 0 ? mesh.lower[1][c] < 1. : m.volume[c] == state.volume[c];
          };
          std::vector<bool> was_full(mesh.n_cells);
          for (Index c = 0; c < mesh.n_cells; ++c)
            was_full[c] = full(c);
          move_nodes(mesh, state, 0.01);
          for (Index c = 0; c < mesh.n_cells; ++c)
            if (was_full[c])
              {
                m.volume[c]          = state.volume[c];
                m.density[c]         = 2.7;
                m.mass[c]            = 2.7 * m.volume[c];
                m.energy[c]          = 0.1;
                m.void_fraction[c]   = 0.3;
                m.fields[0].value[c] = 0.7;
                m.fields[1].value[c] = -0.013;
              }
          for (int d = 0; d < 2; ++d)
            state.velocity[d].assign(mesh.n_nodes, uniform[d]);
          lump(mesh, state);
          const whipple::RemapSums<2> report = remap_case::remap(remap, state, step % 2);
          ASSERT_EQ(report.kinetic_lost, 0.) << report.kinetic_lost;
          for (Index n = 0; n < mesh.n_nodes; ++n)
            for (int d = 0; d < 2 && state.node_mass[n] > 0; ++d)
              ASSERT_EQ(state.velocity[d][n], uniform[d]);
          for (Index c = 0; c < mesh.n_cells; ++c)
            if (m.volume[c] > 0)
              {
                ASSERT_EQ(m.energy[c], 0.1);
                ASSERT_EQ(m.void_fraction[c], 0.3);
                ASSERT_EQ(m.fields[0].value[c], 0.7);
                ASSERT_EQ(m.fields[1].value[c], -0.013);
                if (report.compressed.value() == 0)
                  {
                    ASSERT_EQ(m.density[c], 2.7);
                  }
              }
        }
    }
}
