// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes that give away more than they held: traces at sides and at hanging nodes, corners of the domain.
#include "sparse_states.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
  using namespace remap_case;

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
  std::mt19937 random(11);
  double       worst = 0, hot = 0;
  for (int sample = 0; sample < 300; ++sample)
    {
      const Mesh                   mesh  = halved_mesh(symmetry, random);
      const whipple::Boundaries<2> sides = random_sides(symmetry, random);
      State<2>                     state = sparse_state(mesh, sides, random);

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
