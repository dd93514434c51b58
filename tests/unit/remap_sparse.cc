// SPDX-License-Identifier: LGPL-2.1-or-later
#include "figure.h"
#include "remap_case.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

namespace
{
  using namespace remap_case;
  using whipple::BoundaryKind;

  constexpr int n_materials = 3;

  /// Cells that hold 1e-12 .. 1 of their volume of up to three gases, from cold to hot; velocities of any direction.
  State<2>
  sparse_state(const Mesh &mesh, const double dt, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> unit(-1., 1.), decades(-12., 0.), heat(-8., 0.);
    State<2>                               state = empty_state(mesh, n_materials);
    for (Index n = 0; n < mesh.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        state.velocity[d][n] = mesh.node_side[n] >> 2 * d & 3 ? 0. : unit(random);
    lump(mesh, state); // hanging velocities
    move_nodes(mesh, state, dt);
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        double left = 1.;
        for (whipple::MaterialState &m : state.material)
          {
            if (unit(random) > 0.2)
              continue;
            const double share = left * (unit(random) > 0.7 ? 1. : std::pow(10., decades(random)));
            left -= share;
            if (share < 1e-12)
              continue;
            m.volume[c]  = share * state.volume[c];
            m.density[c] = std::pow(10., 0.5 * unit(random));
            m.mass[c]    = m.density[c] * m.volume[c];
            m.energy[c]  = unit(random) > 0.8 ? 0. : std::pow(10., heat(random));
          }
      }
    lump(mesh, state);
    for (Index n = 0; n < mesh.n_nodes; ++n)
      for (int d = 0; d < 2; ++d)
        if (state.node_mass[n] == 0)
          state.velocity[d][n] = 0;
    lump(mesh, state);
    return state;
  }

  double
  fastest(const State<2> &state, const int d)
  {
    double v = 0;
    for (Index n = 0; n < state.n_nodes(); ++n)
      if (state.node_mass[n] > 0)
        v = std::max(v, std::abs(state.velocity[d][n]));
    return v;
  }

  /// Least specific energy of anything.
  double
  coldest(const State<2> &state)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const whipple::MaterialState &m : state.material)
      for (Index c = 0; c < state.n_cells(); ++c)
        if (m.mass[c] > 0)
          least = std::min(least, m.energy[c]);
    return least;
  }
} // namespace

TEST(RemapSparse, NothingGetsFasterOrColderThanItsDonors)
{
  whipple::figure::Largest speed("sparse random states: growth of the largest velocity in a sweep, cm/us", "<= 1e-13"),
      momentum("sparse random states: relative error of momentum in a sweep", "<= 1e-13"),
      kinetic("sparse random states: relative error of kinetic energy and its booked loss in a sweep", "<= 1e-13");
  double coldest_of_all = 0;
  for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
    for (const bool graded : {false, true})
      for (int sample = 0; sample < 40; ++sample)
        {
          std::mt19937  random(sample);
          const Lattice lattice{symmetry,
                                {0., 0.},
                                1. / 64.,
                                graded ? std::array<int, 2>{4, 4} : std::array<int, 2>{16, 16},
                                graded ? 2 : 0};
          const Mesh    mesh =
              graded_mesh(lattice, [&](const Point &x) { return graded ? std::hypot(x[0], x[1] - 0.1) : 0.; });
          whipple::DirectionalRemap<2> remap(mesh, boundaries(BoundaryKind::reflecting), {});
          State<2>                     state = sparse_state(mesh, 0.44 / 64., random);
          remap.begin(state);
          for (const int axis : {sample % 2, 1 - sample % 2})
            {
              const Totals                before = totals(state);
              const Point                 limit{fastest(state, 0), fastest(state, 1)};
              const whipple::RemapSums<2> report  = remap.sweep(state, axis);
              const Totals                after   = totals(state);
              double                      wall[2] = {0, 0};
              for (const auto &side : report.side)
                for (int d = 0; d < 2; ++d)
                  wall[d] += side.momentum[d];
              const std::string where = "sample " + std::to_string(sample) + " axis " + std::to_string(axis) +
                                        (graded ? " graded" : " uniform");
              for (int d = 0; d < 2; ++d)
                {
                  const double growth = std::max(0., fastest(state, d) - limit[d]);
                  const double lost   = (after.momentum[d] + wall[d] - before.momentum[d]) / before.momentum_scale;
                  speed(growth);
                  momentum(lost);
                  ASSERT_LE(growth, 1e-13) << where;
                  ASSERT_LE(std::abs(lost), 1e-13) << where;
                }
              const double gain = (after.kinetic + report.kinetic_lost - before.kinetic) / before.kinetic;
              kinetic(gain);
              ASSERT_LE(std::abs(gain), 1e-13) << where;
              ASSERT_GE(coldest(state), -1e-16) << where; // round-off of v^2 on gas without any heat
              coldest_of_all = std::min(coldest_of_all, coldest(state));
            }
        }
  whipple::figure::record("sparse random states: least specific energy of gases, Mbar cm3/g", coldest_of_all,
                          ">= -1e-16");
}
