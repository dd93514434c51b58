// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes that give away more than they held: traces at sides and at hanging nodes, corners of the domain.
#include "remap_case.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace
{
  using namespace remap_case;
  using whipple::BoundaryKind;

  constexpr double hottest = 0.01, fastest = 1.;

  /// Levels meet along a random line, which ends at sides of the domain.
  Mesh
  halved_mesh(const Symmetry symmetry, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> unit(0., 1.);
    const double                           angle = 6.28 * unit(random), offset = 0.3 * (unit(random) - 0.5);
    return graded_mesh({symmetry, {0., 0.}, 1. / 24., {6, 6}, 2}, [&](const Point &x) {
      return std::max(0.3 * (std::cos(angle) * (x[0] - 0.5) + std::sin(angle) * (x[1] - 0.5) - offset), 0.);
    });
  }

  /// Mostly nothing, traces of all sizes, some full cells.
  void
  fill_sparsely(State<2> &state, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> unit(0., 1.);
    for (Index c = 0; c < state.n_cells(); ++c)
      {
        const double kind = unit(random), filled = kind < 0.4   ? 0.
                                                   : kind < 0.6 ? 1.
                                                                : std::pow(10., -9. * unit(random));
        const double share = unit(random) < 0.5 ? 1. : std::pow(10., -6. * unit(random));
        for (int m = 0; m < 2; ++m)
          {
            whipple::MaterialState &material = state.material[m];
            material.volume[c]               = state.volume[c] * filled * (m == 0 ? share : 1. - share);
            if (!(material.volume[c] > 0))
              continue;
            material.density[c] = 0.1 + 4. * unit(random);
            material.mass[c]    = material.density[c] * material.volume[c];
            material.energy[c]  = hottest * unit(random);
          }
      }
  }

  whipple::Boundaries<2>
  random_sides(const Symmetry symmetry, std::mt19937 &random)
  {
    const std::array<BoundaryKind, 4> kinds{BoundaryKind::transmitting, BoundaryKind::transmitting,
                                            BoundaryKind::pressure, BoundaryKind::reflecting};
    whipple::Boundaries<2>            sides = boundaries(BoundaryKind::transmitting);
    for (auto &side : sides)
      side.kind = kinds[random() % 4];
    if (symmetry == Symmetry::axisymmetric)
      sides[0].kind = BoundaryKind::reflecting;
    return sides;
  }

  double
  highest_energy(const State<2> &state)
  {
    double highest = 0;
    for (const whipple::MaterialState &material : state.material)
      for (Index c = 0; c < state.n_cells(); ++c)
        if (material.mass[c] > 0)
          highest = std::max(highest, material.energy[c]);
    return highest;
  }

  class RemapDrained : public testing::TestWithParam<std::tuple<Symmetry, bool>>
  {
  };
} // namespace

TEST_P(RemapDrained, NothingIsLostAndNoTraceIsHeatedBeyondTheMixture)
{
  const auto [symmetry, second_order] = GetParam();
  std::mt19937                           random(11);
  std::uniform_real_distribution<double> unit(-fastest, fastest);
  double                                 worst = 0, hot = 0;
  for (int sample = 0; sample < 300; ++sample)
    {
      const Mesh                   mesh  = halved_mesh(symmetry, random);
      const whipple::Boundaries<2> sides = random_sides(symmetry, random);
      State<2>                     state = empty_state(mesh, 2);
      const double                 drift = unit(random); // outwards or inwards, on top of the random part
      for (Index n = 0; n < mesh.n_nodes; ++n)
        for (int d = 0; d < 2; ++d)
          state.velocity[d][n] = whipple::ruling_side<2>(sides, mesh.node_side[n], d) != whipple::none
                                     ? 0.
                                     : 0.5 * unit(random) + drift * (mesh.node_point[d][n] - 0.5);
      lump(mesh, state); // hanging velocities
      move_nodes(mesh, state, 0.44 / 24.);
      fill_sparsely(state, random);
      lump(mesh, state);

      whipple::RemapParameters parameters;
      parameters.second_order = second_order;
      whipple::DirectionalRemap<2> transport(mesh, sides, parameters);
      const Totals                 before = totals(state);
      const whipple::RemapSums<2>  report = remap(transport, state, sample % 2);
      const Totals                 after  = totals(state);
      whipple::SideFlux<2>         left;
      for (const auto &side : report.side)
        {
          left.kinetic += side.kinetic;
          left.internal += side.internal;
          for (int d = 0; d < 2; ++d)
            left.momentum[d] += side.momentum[d];
        }
      const double kinetic  = after.kinetic + left.kinetic + report.kinetic_lost - before.kinetic;
      const double internal = after.internal + left.internal - report.kinetic_heated - before.internal;
      worst                 = std::max({worst, std::abs(kinetic) / before.kinetic, std::abs(internal) / before.internal,
                                        std::abs(report.kinetic_heated - report.kinetic_lost) / before.kinetic});
      for (int d = 0; d < 2; ++d)
        worst = std::max(worst,
                         std::abs(after.momentum[d] + left.momentum[d] - before.momentum[d]) / before.momentum_scale);
      hot = std::max(hot, highest_energy(state));
    }
  std::printf("  largest part lost %.1e, hottest %.3f Mbar cm^3/g\n", worst, hot);
  EXPECT_LT(worst, 1e-13);
  // two sweeps, each at most half the square of the largest difference of velocity between nodes
  EXPECT_LT(hot, hottest + 2. * 0.5 * 2. * 4. * fastest * fastest);
}

INSTANTIATE_TEST_SUITE_P(All, RemapDrained,
                         testing::Combine(testing::Values(Symmetry::planar, Symmetry::axisymmetric), testing::Bool()));
