// SPDX-License-Identifier: LGPL-2.1-or-later
#include "remap_case.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <set>

namespace
{
  using namespace remap_case;
  using whipple::BoundaryKind;

  const Lattice lattice{Symmetry::axisymmetric, {0., 0.}, 1. / 64., {16, 16}, 3};

  /// What one rank sees: every cell whose centre lies in a half of the domain, and its halo, in another order.
  Mesh
  part_of(const Mesh &whole, const bool upper, std::mt19937 &random)
  {
    std::vector<std::vector<Index>> around(whole.n_nodes); // cells at a node, also across hanging ones
    for (Index c = 0; c < whole.n_cells; ++c)
      for (int k = 0; k < 4; ++k)
        around[whole.cell_node[4 * c + k]].push_back(c);
    for (int axis = 0; axis < 2; ++axis)
      for (Index f = 0; f < whole.faces[axis].size(); ++f)
        for (int s = 0; s < 2; ++s)
          if (whole.faces[axis].cell[s][f] != whipple::none)
            for (int t = 0; t < 2; ++t)
              around[whole.faces[axis].node[2 * f + t]].push_back(whole.faces[axis].cell[s][f]);

    std::map<Index, int> layer;
    std::vector<Index>   front;
    for (Index c = 0; c < whole.n_cells; ++c)
      if ((whole.lower[0][c] + 0.6 * whole.lower[1][c] > 1.5) == upper)
        {
          layer[c] = 0;
          front.push_back(c);
        }
    const Index                     n_owned = static_cast<Index>(front.size());
    std::vector<Index>              cells   = front;
    std::vector<std::vector<Index>> touched(whole.n_cells);
    for (Index n = 0; n < whole.n_nodes; ++n)
      for (const Index c : around[n])
        touched[c].push_back(n);
    constexpr int width = whipple::DirectionalRemap<2>::halo_layers;
    for (int l = 1; l <= width; ++l)
      {
        std::vector<Index> next;
        for (const Index c : front)
          for (const Index n : touched[c])
            for (const Index other : around[n])
              if (layer.emplace(other, l).second)
                next.push_back(other);
        cells.insert(cells.end(), next.begin(), next.end());
        front = next;
      }
    std::shuffle(cells.begin(), cells.begin() + n_owned, random);
    std::shuffle(cells.begin() + n_owned, cells.end(), random);
    std::vector<whipple::CellKey> keys;
    std::vector<std::uint8_t>     layers;
    for (const Index c : cells)
      {
        keys.push_back(whole.key[c]);
        layers.push_back(static_cast<std::uint8_t>(layer[c]));
      }
    return whipple::build_flat_mesh<2>(lattice, keys, n_owned, layers, width, whipple::Cohesion::bonded);
  }
} // namespace

TEST(RemapPartition, SameBitsOnEveryPart)
{
  std::mt19937                           random(7);
  std::uniform_real_distribution<double> unit(0., 1.);
  const Mesh                             whole =
      graded_mesh(lattice, [](const Point &x) { return std::min(std::abs(std::hypot(x[0], x[1] - 0.8) - 0.7), 0.15); });
  State<2> state = empty_state(whole, 2);
  for (Index n = 0; n < whole.n_nodes; ++n)
    for (int d = 0; d < 2; ++d)
      state.velocity[d][n] = d == 0 && whole.node_side[n] & 1 ? 0. : unit(random) - 0.5;
  lump(whole, state);
  move_nodes(whole, state, 0.4 / 64.);
  for (Index c = 0; c < whole.n_cells; ++c)
    for (int m = 0; m < 2; ++m)
      {
        const double filled = unit(random) < 0.5 ? 1. : unit(random);
        auto        &p      = state.material[m];
        p.volume[c]         = (whole.lower[1][c] < 0.9) == (m == 0) ? filled * state.volume[c] : 0.;
        if (p.volume[c] == 0)
          continue;
        p.density[c]       = 1. + unit(random);
        p.mass[c]          = p.density[c] * p.volume[c];
        p.energy[c]        = unit(random);
        p.void_fraction[c] = 0.5 * unit(random);
        for (int i = 0; i < 2; ++i)
          p.fields[i].value[c] = unit(random);
      }
  lump(whole, state);
  whipple::Boundaries<2> sides = boundaries(BoundaryKind::transmitting);
  sides[0].kind                = BoundaryKind::reflecting;

  for (const int axis : {0, 1})
    {
      State<2>                     done = state;
      whipple::DirectionalRemap<2> remap(whole, sides, {});
      remap.begin(done);
      whipple::RemapSums<2> report = remap.sweep(done, axis), sum;
      for (const bool upper : {false, true})
        {
          const Mesh part = part_of(whole, upper, random);
          ASSERT_LT(part.n_cells, whole.n_cells);
          std::map<whipple::CellKey, Index> place;
          for (Index c = 0; c < whole.n_cells; ++c)
            place[whole.key[c]] = c;
          State<2>   local = empty_state(part, 2);
          State<2>   start = state;
          const auto copy  = [&](const int entries, const Mesh &to, const Mesh &from) {
            return [&, entries](std::vector<double> &a, std::vector<double> &b) {
              for (Index c = 0; c < part.n_cells; ++c)
                for (int k = 0; k < entries; ++k)
                  {
                    const Index g                                 = place[part.key[c]];
                    a[entries == 1 ? c : to.cell_node[4 * c + k]] = b[entries == 1 ? g : from.cell_node[4 * g + k]];
                  }
            };
          };
          visit(local, start, copy(1, part, whole), copy(4, part, whole));
          // the outermost layer may hold anything: it is not reached
          for (Index c = 0; c < part.n_cells; ++c)
            if (part.layer[c] == part.halo_width)
              for (auto *value : {&local.material[0].volume, &local.material[0].mass, &local.material[0].density,
                                  &local.material[0].energy, &local.volume})
                (*value)[c] = std::numeric_limits<double>::quiet_NaN();
          whipple::DirectionalRemap<2> local_remap(part, sides, {});
          local_remap.begin(local);
          sum += local_remap.sweep(local, axis);
          int        different = 0;
          const auto compare   = [&](const int entries) {
            return [&, entries](const std::vector<double> &a, const std::vector<double> &b) {
              for (Index c = 0; c < part.n_owned; ++c)
                for (int k = 0; k < entries; ++k)
                  {
                    const Index g = place[part.key[c]];
                    different += a[entries == 1 ? c : part.cell_node[4 * c + k]] !=
                                 b[entries == 1 ? g : whole.cell_node[4 * g + k]];
                  }
            };
          };
          visit(local, done, compare(1), compare(4));
          EXPECT_EQ(different, 0);
        }
      EXPECT_NEAR(sum.kinetic_lost, report.kinetic_lost, 1e-14);
      EXPECT_NEAR(sum.kinetic_heated, report.kinetic_heated, 1e-14);
      for (int s = 0; s < 4; ++s)
        {
          EXPECT_NEAR(sum.side[s].mass, report.side[s].mass, 1e-14);
          EXPECT_NEAR(sum.side[s].momentum[1], report.side[s].momentum[1], 1e-14);
          EXPECT_NEAR(sum.side[s].internal, report.side[s].internal, 1e-14);
        }
      EXPECT_EQ(sum.remnant_cells, report.remnant_cells);
    }
}
