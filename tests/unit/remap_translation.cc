// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../connected_pieces.h"
#include "remap_case.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace
{
  using namespace remap_case;
  using whipple::BoundaryKind;

  constexpr double speed = 0.658; // cm/us

  /// Fill cells by sampling a body on 32 x 32 points, r-weighted where the cell is a ring; all of it moves with v.
  void
  fill_body(const Mesh &mesh, State<2> &state, const std::function<bool(const Point &)> &inside, const Point &v)
  {
    whipple::MaterialState &material = state.material[0];
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        constexpr int n  = 32;
        double        in = 0, all = 0;
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i)
            {
              const Point  x{mesh.lower[0][c] + (i + 0.5) / n * mesh.size[c],
                            mesh.lower[1][c] + (j + 0.5) / n * mesh.size[c]};
              const double w = mesh.symmetry == Symmetry::planar ? 1. : x[0];
              all += w;
              in += inside(x) ? w : 0.;
            }
        if (in == 0)
          continue;
        material.volume[c]          = in == all ? state.volume[c] : state.volume[c] * (in / all);
        material.density[c]         = 2.7;
        material.mass[c]            = 2.7 * material.volume[c];
        material.energy[c]          = 1e-4;
        material.void_fraction[c]   = 0.01;
        material.fields[0].value[c] = 0.3;
        material.fields[1].value[c] = -0.002;
        for (int k = 0; k < 4; ++k)
          for (int d = 0; d < 2; ++d)
            state.velocity[d][mesh.cell_node[4 * c + k]] = v[d];
      }
    lump(mesh, state);
  }

  /// Volume of the difference to the body where it should be, as a share of its volume.
  double
  shape_error(const State<2> &state, const State<2> &exact)
  {
    double difference = 0, volume = 0;
    for (Index c = 0; c < state.n_cells(); ++c)
      {
        difference += std::abs(state.material[0].volume[c] - exact.material[0].volume[c]);
        volume += exact.material[0].volume[c];
      }
    return difference / volume;
  }

  void
  write_cells(const Mesh &mesh, const State<2> &state, const char *name)
  {
    const char *directory = std::getenv("WHIPPLE_TEST_OUTPUT");
    if (!directory)
      return;
    std::FILE *file = std::fopen((std::string(directory) + "/" + name).c_str(), "w");
    for (Index c = 0; c < mesh.n_cells; ++c)
      std::fprintf(file, "%.17g %.17g %.17g %.17g\n", mesh.lower[0][c], mesh.lower[1][c], mesh.size[c],
                   state.material[0].volume[c] / state.volume[c]);
    std::fclose(file);
  }

  struct Extremes
  {
    double velocity_error = 0, value_error = 0;
  };

  /// Largest deviation of velocity and of carried quantities from what they were everywhere.
  Extremes
  deviation(const State<2> &state, const Point &v)
  {
    Extremes e;
    for (Index n = 0; n < state.n_nodes(); ++n)
      if (state.node_mass[n] > 0)
        for (int d = 0; d < 2; ++d)
          e.velocity_error = std::max(e.velocity_error, std::abs(state.velocity[d][n] - v[d]));
    const whipple::MaterialState &m = state.material[0];
    for (Index c = 0; c < state.n_cells(); ++c)
      if (m.volume[c] > 0)
        for (const double error :
             {m.energy[c] - 1e-4, m.void_fraction[c] - 0.01, m.fields[0].value[c] - 0.3, m.fields[1].value[c] + 0.002})
          e.value_error = std::max(e.value_error, std::abs(error));
    return e;
  }

  /// Move on for a time at uniform velocity, all nodes that hold mass together; steps at the advection limit.
  whipple::RemapSums<2>
  fly(const Mesh &mesh, State<2> &state, whipple::DirectionalRemap<2> &remap, const Point &v, const double end)
  {
    whipple::RemapSums<2> report;
    int                   step = 0;
    for (double time = 0; time < end; ++step)
      {
        const double dt = std::min(remap.time_step(state).dt, end - time);
        time            = end - time <= dt ? end : time + dt;
        // material that a step reaches moves rigidly: so do the empty nodes around it
        for (int d = 0; d < 2; ++d)
          for (Index n = 0; n < mesh.n_nodes; ++n)
            state.position[d][n] = mesh.node_point[d][n] + (state.node_mass[n] > 0 ? dt * v[d] : 0.);
        for (std::size_t i = 0; i < mesh.hanging.size(); ++i)
          for (int d = 0; d < 2; ++d)
            state.position[d][mesh.hanging[i]] =
                0.5 * (state.position[d][mesh.master[i][0]] + state.position[d][mesh.master[i][1]]);
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            const double before = state.volume[c], after = cell_volume(mesh, state, c);
            if (state.material[0].volume[c] == before)
              state.material[0].volume[c] = after;
            state.volume[c] = after;
          }
        report += remap_case::remap(remap, state, step % 2);
      }
    return report;
  }
} // namespace

TEST(RemapTranslation, SphereOverTenDiametersAcrossLevels)
{
  constexpr double radius = 0.16, h = 0.016;
  // finest cells along the path for the first half, twice as large in the second: the sphere crosses the step
  const Lattice lattice{Symmetry::axisymmetric, {0., 0.}, h, {8, 60}, 2};
  const Mesh    mesh = graded_mesh(lattice, [&](const Point &x) {
    const double out = std::max(0., x[0] - 0.25);
    return std::max(out, x[1] > 2. ? 0.072 : 0.);
  });
  ASSERT_GT(mesh.hanging.size(), 20u);
  whipple::Boundaries<2> sides = boundaries(BoundaryKind::transmitting);
  sides[0].kind                = BoundaryKind::reflecting;
  whipple::DirectionalRemap<2> remap(mesh, sides, {});
  const Point                  v{0., speed};
  const auto                   sphere = [&](const double z) {
    return [=](const Point &x) { return std::hypot(x[0], x[1] - z) < radius; };
  };

  State<2> state = empty_state(mesh, 1), exact = state;
  fill_body(mesh, state, sphere(0.24), v);
  fill_body(mesh, exact, sphere(0.24 + 20. * radius), v);
  const Totals                before = totals(state);
  const whipple::RemapSums<2> report = fly(mesh, state, remap, v, 20. * radius / speed);
  const Totals                after  = totals(state);
  write_cells(mesh, state, "sphere.txt");
  write_cells(mesh, exact, "sphere_exact.txt");

  EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
  EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-12 * before.momentum[1]);
  EXPECT_LT(std::abs(after.internal - before.internal), 1e-8 * before.kinetic);
  EXPECT_EQ(report.kinetic_lost, 0.);
  EXPECT_LT(report.remnant_mass.value(), 1e-6 * before.mass);
  EXPECT_EQ(whipple::connected_pieces(mesh, state, 0.), 1);
  const Extremes e = deviation(state, v);
  EXPECT_EQ(e.velocity_error, 0.);
  EXPECT_EQ(e.value_error, 0.);
  const double error = shape_error(state, exact);
  RecordProperty("shape_error_percent", std::to_string(100. * error));
  EXPECT_LT(error, 0.01);
}

TEST(RemapTranslation, DiscObliquelyAcrossLevels)
{
  // planar, along (2, 1), finest cells in bands that the disc crosses at an angle
  const Mesh mesh = graded_mesh({Symmetry::planar, {0., 0.}, 0.01, {25, 14}, 3}, [&](const Point &x) {
    return x[0] < 0.8 ? 0. : x[0] < 1.3 ? 0.045 : std::max(0., 0.09 - 0.2 * std::abs(x[1] - 1.));
  });
  ASSERT_GT(mesh.hanging.size(), 20u);
  whipple::DirectionalRemap<2> remap(mesh, boundaries(BoundaryKind::transmitting), {});
  const Point                  v{speed, 0.5 * speed};
  const auto                   disc = [&](const double x0, const double y0) {
    return [=](const Point &x) { return std::hypot(x[0] - x0, x[1] - y0) < 0.16; };
  };
  State<2> state = empty_state(mesh, 1), exact = state;
  fill_body(mesh, state, disc(0.25, 0.25), v);
  fill_body(mesh, exact, disc(1.65, 0.95), v);
  const Totals                before = totals(state);
  const whipple::RemapSums<2> report = fly(mesh, state, remap, v, 1.4 / speed);
  const Totals                after  = totals(state);
  write_cells(mesh, state, "disc.txt");
  write_cells(mesh, exact, "disc_exact.txt");

  EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
  for (int d = 0; d < 2; ++d)
    EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-12 * before.momentum[d]);
  EXPECT_EQ(report.kinetic_lost, 0.);
  EXPECT_EQ(whipple::connected_pieces(mesh, state, 0.), 1);
  const Extremes e = deviation(state, v);
  EXPECT_EQ(e.velocity_error, 0.);
  EXPECT_EQ(e.value_error, 0.);
  const double error = shape_error(state, exact);
  RecordProperty("shape_error_percent", std::to_string(100. * error));
  EXPECT_LT(error, 0.03);
}

TEST(RemapTranslation, ThinPlateStaysAPlate)
{
  constexpr double       h     = 0.02;
  const Mesh             mesh  = uniform_mesh(Symmetry::axisymmetric, h, {16, 120});
  whipple::Boundaries<2> sides = boundaries(BoundaryKind::transmitting);
  sides[0].kind                = BoundaryKind::reflecting;
  whipple::DirectionalRemap<2> remap(mesh, sides, {});
  const Point                  v{0., speed};
  const auto plate = [&](const double z) { return [=](const Point &x) { return x[1] > z && x[1] < z + 4. * h; }; };
  State<2>   state = empty_state(mesh, 1), exact = state;
  fill_body(mesh, state, plate(0.08), v);
  fill_body(mesh, exact, plate(0.08 + 1.6), v);
  const Totals before = totals(state);
  fly(mesh, state, remap, v, 1.6 / speed);
  const Totals after = totals(state);

  EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
  EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-12 * before.momentum[1]);
  EXPECT_LT(std::abs(after.internal - before.internal), 1e-12 * before.kinetic);
  EXPECT_EQ(whipple::connected_pieces(mesh, state, 0.), 1);
  const Extremes e = deviation(state, v);
  EXPECT_EQ(e.velocity_error, 0.);
  EXPECT_EQ(e.value_error, 0.);
  EXPECT_LT(shape_error(state, exact), 1e-10);
}
