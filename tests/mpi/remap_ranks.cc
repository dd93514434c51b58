// SPDX-License-Identifier: LGPL-2.1-or-later
// Chains of drained nodes that are longer than the halo is wide: the same bits on any number of ranks.
#include "../unit/sparse_states.h"

#include <whipple/mesh/collective.h>
#include <whipple/mesh/flat_partition.h>

#include <gtest/gtest.h>

#include <map>
#include <numeric>

namespace
{
  using namespace remap_case;
  using Partition = whipple::FlatPartition<2>;

  /// This rank's part: as many cells as the others have, in the order of the whole mesh.
  std::unique_ptr<Partition>
  part_of(const Mesh &whole, const Lattice &lattice)
  {
    int rank = 0, ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const auto first = [&](const int r) { return whole.key.begin() + whole.n_cells * r / ranks; };
    const std::vector<whipple::CellKey> leaves(first(rank), first(rank + 1));
    return whipple::flatten_leaves<2>(MPI_COMM_WORLD, lattice, leaves, std::vector<std::uint8_t>(leaves.size(), 1),
                                      whipple::DirectionalRemap<2>::halo_layers, whipple::Cohesion::bonded);
  }

  /// Values of owned cells and their nodes that differ from the whole domain's after a sweep, on all ranks.
  int
  values_that_differ(const Mesh &whole, const Lattice &lattice, const whipple::Boundaries<2> &sides, State<2> state,
                     const int axis, const bool exchanged)
  {
    const std::unique_ptr<Partition>  partition = part_of(whole, lattice);
    const Mesh                       &part      = partition->mesh;
    std::map<whipple::CellKey, Index> place;
    for (Index c = 0; c < whole.n_cells; ++c)
      place[whole.key[c]] = c;
    State<2>   local = empty_state(part, 2);
    const auto each  = [&](const Index cells, const int entries, const auto &act) {
      return [&, cells, entries](std::vector<double> &a, std::vector<double> &b) {
        for (Index c = 0; c < cells; ++c)
          for (int k = 0; k < entries; ++k)
            {
              const Index g = place.at(part.key[c]);
              act(a[entries == 1 ? c : part.cell_node[4 * c + k]], b[entries == 1 ? g : whole.cell_node[4 * g + k]]);
            }
      };
    };
    const auto copy = [](double &a, const double b) { a = b; };
    visit(local, state, each(part.n_cells, 1, copy), each(part.n_cells, 4, copy));

    whipple::DirectionalRemap<2> remap(whole, sides, {}), local_remap(part, sides, {});
    remap.begin(state);
    remap.sweep(state, axis);
    local_remap.begin(local);
    whipple::agree_in_parts(MPI_COMM_WORLD, [&](const auto &meet) {
      using Halo = whipple::MeetingHalo<2>;
      local_remap.sweep(local, axis, exchanged ? Halo(partition->halo, meet) : Halo());
    });
    int        different = 0;
    const auto compare   = [&](const double a, const double b) { different += a != b; };
    visit(local, state, each(part.n_owned, 1, compare), each(part.n_owned, 4, compare));
    MPI_Allreduce(MPI_IN_PLACE, &different, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    return different;
  }

  TEST(RemapRanks, DrainedNodesThatFeedEachOtherAcrossRanksGiveTheSame)
  {
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    std::mt19937 random(23);
    int          different = 0, without_exchange = 0;
    for (int sample = 0; sample < 60; ++sample)
      {
        const Symmetry               symmetry = sample % 2 ? Symmetry::planar : Symmetry::axisymmetric;
        const Mesh                   whole    = halved_mesh(symmetry, random);
        const whipple::Boundaries<2> sides    = random_sides(symmetry, random);
        const State<2>               state    = sparse_state(whole, sides, random);
        const int                    axis     = sample / 2 % 2;
        different += values_that_differ(whole, unit_lattice(symmetry), sides, state, axis, true) > 0;
        without_exchange += values_that_differ(whole, unit_lattice(symmetry), sides, state, axis, false) > 0;
      }
    EXPECT_EQ(different, 0);
    EXPECT_EQ(without_exchange > 0, ranks > 1) << "the samples have such chains";
  }
} // namespace
