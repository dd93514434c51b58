// SPDX-License-Identifier: LGPL-2.1-or-later
// Shapes that a given velocity field turns, or draws out and brings back, through the remap alone.
#include "../connected_pieces.h"
#include "../unit/remap_case.h"
#include "case_record.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace
{
  using namespace remap_case;
  using whipple::stability::Case;

  constexpr double pi = std::numbers::pi;

  /// Material of density 1 inside a shape, by sampling.
  void
  fill(const Mesh &mesh, State<2> &state, const std::function<bool(const Point &)> &inside)
  {
    whipple::MaterialState &material = state.material[0];
    constexpr int           n        = 32;
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        int in = 0;
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i)
            in += inside(
                {mesh.lower[0][c] + (i + 0.5) / n * mesh.size[c], mesh.lower[1][c] + (j + 0.5) / n * mesh.size[c]});
        if (in == 0)
          continue;
        material.volume[c]  = in == n * n ? state.volume[c] : state.volume[c] * in / (n * n);
        material.density[c] = 1.;
        material.mass[c]    = material.volume[c];
        material.energy[c]  = 1e-3;
      }
    lump(mesh, state);
  }

  /// Carry the material with a velocity that is given at all times; the density follows the cells' volumes.
  void
  carry(const Mesh &mesh, State<2> &state, double end, int steps,
        const std::function<Point(const Point &, double)> &field)
  {
    whipple::DirectionalRemap<2> remap(mesh, boundaries(whipple::BoundaryKind::reflecting), {});
    const double                 dt = end / steps;
    for (int step = 0; step < steps; ++step)
      {
        for (Index n = 0; n < mesh.n_nodes; ++n)
          {
            // second order in time: the velocity at half time, where the node is then
            const Point x{mesh.node_point[0][n], mesh.node_point[1][n]};
            const Point v = field(x, step * dt);
            const Point w = field({x[0] + 0.5 * dt * v[0], x[1] + 0.5 * dt * v[1]}, (step + 0.5) * dt);
            for (int d = 0; d < 2; ++d)
              state.velocity[d][n] = w[d];
          }
        const std::vector<double> before = state.volume;
        move_nodes(mesh, state, dt);
        for (Index c = 0; c < mesh.n_cells; ++c)
          {
            whipple::MaterialState &m = state.material[0];
            m.volume[c] = m.volume[c] == before[c] ? state.volume[c] : m.volume[c] / before[c] * state.volume[c];
            if (m.volume[c] > 0)
              m.density[c] = m.mass[c] / m.volume[c];
          }
        remap_case::remap(remap, state, step % 2);
      }
  }

  void
  expect_shape(Case &table, const Mesh &mesh, const State<2> &before, const State<2> &after)
  {
    double mass = 0, mass_before = 0, volume = 0, volume_before = 0, difference = 0, first[2] = {0, 0},
           first_before[2] = {0, 0};
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        const whipple::MaterialState &a = after.material[0], &b = before.material[0];
        mass += a.mass[c];
        mass_before += b.mass[c];
        volume += a.volume[c];
        volume_before += b.volume[c];
        difference += std::abs(a.volume[c] - b.volume[c]);
        for (int d = 0; d < 2; ++d)
          {
            first[d] += a.mass[c] * (mesh.lower[d][c] + 0.5 * mesh.size[c]);
            first_before[d] += b.mass[c] * (mesh.lower[d][c] + 0.5 * mesh.size[c]);
          }
      }
    table.at_most("mass, relative change", std::abs(mass / mass_before - 1.), 1e-12);
    table.within("volume / that at the start", volume / volume_before, 1., 0.01);
    for (int d = 0; d < 2; ++d)
      table.within("centre along axis " + std::to_string(d) + " / that at the start",
                   first[d] / mass / (first_before[d] / mass_before), 1., 0.01);
    table.at_most("pieces", whipple::connected_pieces(mesh, after, 0.01), 1);
    table.report("shape error, sum of |V - V exact| / V", difference / volume_before);
  }
} // namespace

/// [Zalesak1979]: a disc with a slot turns once.
TEST(Shapes, ZalesakDisc)
{
  Case table("Zalesak's disc, 100 x 100 cells, one turn", "the disc falls to pieces or loses volume", "remap alone");
  const Mesh mesh   = uniform_mesh(Symmetry::planar, 0.01, {100, 100});
  State<2>   before = empty_state(mesh, 1);
  fill(mesh, before, [](const Point &x) {
    return std::hypot(x[0] - 0.5, x[1] - 0.75) < 0.15 && !(std::abs(x[0] - 0.5) < 0.025 && x[1] < 0.85);
  });
  State<2> state = before;
  carry(mesh, state, 2. * pi, 800, [](const Point &x, double) {
    // at rest near the sides, which the disc never reaches
    return std::hypot(x[0] - 0.5, x[1] - 0.5) < 0.46 ? Point{0.5 - x[1], x[0] - 0.5} : Point{0., 0.};
  });
  expect_shape(table, mesh, before, state);
}

/// [LeVeque1996]: a vortex draws a disc out and brings it back.
TEST(QuickShapes, VortexReversal)
{
  Case             table("disc drawn out by a vortex and brought back, 64 x 64 cells, period 2",
                         "the filament breaks, volume is lost", "remap alone");
  const Mesh       mesh   = uniform_mesh(Symmetry::planar, 1. / 64., {64, 64});
  constexpr double period = 2.;
  State<2>         before = empty_state(mesh, 1);
  fill(mesh, before, [](const Point &x) { return std::hypot(x[0] - 0.5, x[1] - 0.75) < 0.15; });
  State<2> state = before;
  carry(mesh, state, period, 320, [](const Point &x, double t) {
    const double turn = std::cos(pi * t / period);
    return Point{{-turn * std::pow(std::sin(pi * x[0]), 2) * std::sin(2. * pi * x[1]),
                  turn * std::pow(std::sin(pi * x[1]), 2) * std::sin(2. * pi * x[0])}};
  });
  expect_shape(table, mesh, before, state);
}
