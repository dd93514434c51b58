// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/flat_partition.h>
#include <whipple/mesh/gather.h>
#include <whipple/mesh/leaf_neighbours.h>

#include <algorithm>
#include <string>

namespace whipple
{
  namespace
  {
    /// A cell of another rank that this rank needs.
    struct HaloCell
    {
      CellKey      key;
      std::uint8_t layer;
      int          owner;
    };

    /// Breadth-first from this rank's cells through touching cells; ordered by key.
    template <int dim>
    std::vector<HaloCell>
    find_halo(const Lattice<dim> &lattice, const Gathered<CellKey> &cells, const KeyIndex &index, int rank,
              int halo_width)
    {
      std::vector<std::uint8_t> reached(cells.entry.size(), 0);
      std::vector<Index>        front;
      for (int i = cells.first[rank]; i < cells.first[rank + 1]; ++i)
        {
          reached[i] = 1;
          front.push_back(i);
        }

      std::vector<HaloCell> halo;
      for (int layer = 1; layer <= halo_width; ++layer)
        {
          std::vector<Index> next;
          for (const Index cell : front)
            for_each_touching(lattice, index, cells.entry[cell], [&](Index other) {
              if (reached[other])
                return;
              reached[other]   = 1;
              const auto after = std::upper_bound(cells.first.begin(), cells.first.end(), other);
              halo.push_back({cells.entry[other], static_cast<std::uint8_t>(layer),
                              static_cast<int>(after - cells.first.begin()) - 1});
              next.push_back(other);
            });
          front = std::move(next);
        }
      std::sort(halo.begin(), halo.end(), [](const HaloCell &a, const HaloCell &b) { return a.key < b.key; });
      return halo;
    }

    /// Tell every owner which of its cells this rank needs (`wanted[rank]`), and learn who needs which of ours.
    Gathered<CellKey>
    exchange_wishes(MPI_Comm communicator, const std::vector<std::vector<CellKey>> &wanted)
    {
      const int            ranks = static_cast<int>(wanted.size());
      std::vector<int>     send_count(ranks), send_first(ranks), receive_count(ranks);
      std::vector<CellKey> send;
      for (int r = 0; r < ranks; ++r)
        {
          send_count[r] = static_cast<int>(wanted[r].size());
          send_first[r] = static_cast<int>(send.size());
          send.insert(send.end(), wanted[r].begin(), wanted[r].end());
        }
      MPI_Alltoall(send_count.data(), 1, MPI_INT, receive_count.data(), 1, MPI_INT, communicator);

      Gathered<CellKey> wishes;
      wishes.first.assign(ranks + 1, 0);
      for (int r = 0; r < ranks; ++r)
        wishes.first[r + 1] = wishes.first[r] + receive_count[r];
      wishes.entry.resize(wishes.first[ranks]);
      MPI_Alltoallv(send.data(), send_count.data(), send_first.data(), MPI_UINT64_T, wishes.entry.data(),
                    receive_count.data(), wishes.first.data(), MPI_UINT64_T, communicator);
      return wishes;
    }

    template <int dim>
    std::vector<typename Halo<dim>::Neighbour>
    find_neighbours(MPI_Comm communicator, const std::vector<HaloCell> &halo, const Gathered<CellKey> &cells,
                    const KeyIndex &index, int rank)
    {
      const int                         ranks   = static_cast<int>(cells.first.size()) - 1;
      const Index                       n_owned = cells.first[rank + 1] - cells.first[rank];
      std::vector<std::vector<CellKey>> wanted(ranks);
      std::vector<std::vector<Index>>   receive(ranks);
      for (std::size_t h = 0; h < halo.size(); ++h)
        {
          wanted[halo[h].owner].push_back(halo[h].key);
          receive[halo[h].owner].push_back(n_owned + static_cast<Index>(h));
        }
      const Gathered<CellKey> wishes = exchange_wishes(communicator, wanted);

      std::vector<typename Halo<dim>::Neighbour> neighbours;
      for (int r = 0; r < ranks; ++r)
        {
          std::vector<Index> send;
          for (int i = wishes.first[r]; i < wishes.first[r + 1]; ++i)
            send.push_back(index.find(wishes.entry[i]) - cells.first[rank]);
          if (!send.empty() || !receive[r].empty())
            neighbours.push_back({r, std::move(send), std::move(receive[r])});
        }
      return neighbours;
    }
  } // namespace

  template <int dim>
  std::unique_ptr<FlatPartition<dim>>
  flatten_leaves(MPI_Comm communicator, const Lattice<dim> &lattice, std::span<const CellKey> leaves,
                 std::span<const std::uint8_t> active, int halo_width, const Bonds &bonds)
  {
    if (leaves.size() != active.size())
      throw StateError(std::to_string(active.size()) + " activity flags for " + std::to_string(leaves.size()) +
                       " leaves");
    bonds.require_size(leaves.size());
    auto                      partition = std::make_unique<FlatPartition<dim>>();
    std::vector<CellKey>      keys;
    std::vector<std::uint8_t> intact;
    for (std::size_t i = 0; i < leaves.size(); ++i)
      if (active[i])
        {
          keys.push_back(leaves[i]);
          intact.push_back(bonds.intact(i));
          partition->leaf_of_cell.push_back(static_cast<Index>(i));
        }
    const Index               n_owned = static_cast<Index>(keys.size());
    std::vector<std::uint8_t> layer(keys.size(), 0);

    int rank, ranks;
    MPI_Comm_rank(communicator, &rank);
    MPI_Comm_size(communicator, &ranks);
    std::vector<typename Halo<dim>::Neighbour> neighbours;
    if (ranks > 1 && halo_width > 0)
      {
        const auto                  cells = gather_all<CellKey>(communicator, keys);
        const auto                  whole = gather_all<std::uint8_t>(communicator, intact);
        const KeyIndex              index(cells.entry);
        const std::vector<HaloCell> halo = find_halo(lattice, cells, index, rank, halo_width);
        neighbours                       = find_neighbours<dim>(communicator, halo, cells, index, rank);
        for (const HaloCell &cell : halo)
          {
            keys.push_back(cell.key);
            layer.push_back(cell.layer);
            intact.push_back(whole.entry[index.find(cell.key)]);
          }
      }
    partition->mesh =
        build_flat_mesh<dim>(lattice, std::move(keys), n_owned, std::move(layer), halo_width, Bonds(std::move(intact)));
    partition->halo = Halo<dim>(communicator, partition->mesh, std::move(neighbours));
    return partition;
  }

  template std::unique_ptr<FlatPartition<2>>
  flatten_leaves<2>(MPI_Comm, const Lattice<2> &, std::span<const CellKey>, std::span<const std::uint8_t>, int,
                    const Bonds &);
} // namespace whipple
