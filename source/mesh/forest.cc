// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/forest.h>
#include <whipple/mesh/gather.h>
#include <whipple/mesh/key_arithmetic.h>
#include <whipple/mesh/level_agreement.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace whipple
{
  namespace
  {
    template <int dim>
    using Triangulation = dealii::parallel::distributed::Triangulation<dim>;

    std::vector<char>
    to_bytes(const CellPacket &packet)
    {
      std::vector<char> bytes(packet.size() * sizeof(double));
      if (!packet.empty())
        std::memcpy(bytes.data(), packet.data(), bytes.size());
      return bytes;
    }

    template <class ByteRange>
    CellPacket
    from_bytes(const ByteRange &bytes)
    {
      CellPacket packet(bytes.size() / sizeof(double));
      if (!packet.empty())
        std::memcpy(packet.data(), &*bytes.begin(), packet.size() * sizeof(double));
      return packet;
    }
  } // namespace

  template <int dim>
  class Forest<dim>::Implementation
  {
  public:
    using Cell     = typename Triangulation<dim>::cell_iterator;
    using Status   = typename Triangulation<dim>::CellStatus;
    using Children = typename PacketRemap<dim>::Children;

    Implementation(MPI_Comm communicator, const Lattice<dim> &lattice_)
      : lattice(lattice_)
      , triangulation(communicator, dealii::Triangulation<dim>::none)
    {
      require_packable(lattice);
      MPI_Comm_rank(communicator, &rank);
      std::vector<unsigned int> roots(dim);
      dealii::Point<dim>        upper;
      for (int d = 0; d < dim; ++d)
        {
          roots[d] = lattice.roots[d];
          upper[d] = lattice.finest(d);
        }
      dealii::GridGenerator::subdivided_hyper_rectangle(triangulation, roots, dealii::Point<dim>(), upper);
      read_leaves();
      all = gather_all<CellKey>(communicator, key);
    }

    std::span<const CellKey>
    owned() const
    {
      return std::span<const CellKey>(all.entry).subspan(all.first[rank], all.first[rank + 1] - all.first[rank]);
    }

    void
    require_one_each(std::size_t n, const std::string &what) const
    {
      if (n != owned().size())
        throw StateError(std::to_string(n) + " " + what + " for " + std::to_string(owned().size()) + " leaves");
    }

    /// Set deal.II's flags to what has been agreed on.
    void
    flag(std::span<const std::uint8_t> level)
    {
      for (std::size_t i = 0; i < cell.size(); ++i)
        if (level[i] > cell[i]->level())
          cell[i]->set_refine_flag();
        else if (level[i] < cell[i]->level())
          cell[i]->set_coarsen_flag();
    }

    /// Run `change` (adaptation or repartitioning by deal.II) with the packets attached to the cells, then read the
    /// new leaves and hand the packets back in their order.
    template <class Change>
    void
    change_with_packets(std::vector<CellPacket> &packets, const PacketRemap<dim> &remap, const LeafWeight &weight,
                        std::vector<CellKey> expected, const Change &change)
    {
      const unsigned int handle = triangulation.register_data_attach(
          [&](const Cell &at, const Status status) {
            return status == Triangulation<dim>::CELL_COARSEN ? to_bytes(merged(at, packets, remap))
                                                              : to_bytes(packets[leaf_of(at)]);
          },
          /*variable size*/ true);
      boost::signals2::scoped_connection connection;
      if (weight)
        connection = triangulation.signals.weight.connect(
            [&](const Cell &at, const Status status) { return work(at, status, packets, weight); });
      change();

      read_leaves();
      require_agreed(std::move(expected));
      std::vector<CellPacket> moved(key.size());
      triangulation.notify_ready_to_unpack(handle,
                                           [&](const Cell &at, const Status status,
                                               const boost::iterator_range<std::vector<char>::const_iterator> &bytes) {
                                             if (status == Triangulation<dim>::CELL_REFINE)
                                               split(at, from_bytes(bytes), moved, remap);
                                             else
                                               moved[leaf_of(at)] = from_bytes(bytes);
                                           });
      packets = std::move(moved);
    }

    const Lattice<dim> lattice;
    Triangulation<dim> triangulation;
    int                rank;
    Gathered<CellKey>  all; ///< all leaves in forest order, and where each rank's begin

  private:
    Index
    leaf_of(const Cell &at) const
    {
      return leaf[at->active_cell_index()];
    }

    CellPacket
    merged(const Cell &parent, const std::vector<CellPacket> &packets, const PacketRemap<dim> &remap) const
    {
      Children children;
      bool     empty = true;
      for (unsigned int k = 0; k < children.size(); ++k)
        {
          children[k] = packets[leaf_of(parent->child(k))];
          empty       = empty && children[k].empty();
        }
      const CellKey first = owned()[leaf_of(parent->child(0))];
      return empty ? CellPacket() : remap.merge(ancestor_key(lattice, first, key_level(first) - 1), children);
    }

    void
    split(const Cell &parent, const CellPacket &packet, std::vector<CellPacket> &moved,
          const PacketRemap<dim> &remap) const
    {
      if (packet.empty())
        return;
      const CellKey first    = key[leaf_of(parent->child(0))];
      Children      children = remap.split(ancestor_key(lattice, first, key_level(first) - 1), packet);
      for (unsigned int k = 0; k < children.size(); ++k)
        moved[leaf_of(parent->child(k))] = std::move(children[k]);
    }

    /// Work of the leaf to come: a child will hold material if its parent does, a parent if a child does.
    unsigned int
    work(const Cell &at, const Status status, const std::vector<CellPacket> &packets, const LeafWeight &weight) const
    {
      if (status != Triangulation<dim>::CELL_COARSEN)
        return weight(packets[leaf_of(at)]);
      unsigned int most = 0;
      for (unsigned int k = 0; k < at->n_children(); ++k)
        most = std::max(most, weight(packets[leaf_of(at->child(k))]));
      return most;
    }

    /// This rank's leaves in forest order: trees in p4est's order, each depth-first.
    void
    read_leaves()
    {
      key.clear();
      cell.clear();
      leaf.assign(triangulation.n_active_cells(), none);
      for (const unsigned int root : triangulation.get_p4est_tree_to_coarse_cell_permutation())
        {
          const Cell        at(&triangulation, 0, root);
          LatticePoint<dim> corner;
          for (int d = 0; d < dim; ++d)
            corner[d] = static_cast<int>(std::lround(at->vertex(0)[d]));
          descend(at, make_key<dim>(0, corner));
        }
    }

    void
    descend(const Cell &at, CellKey at_key)
    {
      if (at->has_children())
        {
          for (unsigned int k = 0; k < at->n_children(); ++k)
            descend(at->child(k), child_key(lattice, at_key, k));
          return;
        }
      if (!at->is_locally_owned())
        return;
      leaf[at->active_cell_index()] = static_cast<Index>(key.size());
      key.push_back(at_key);
      cell.push_back(at);
    }

    /// Take over the agreed leaves as the present ones, if they are.
    void
    require_agreed(std::vector<CellKey> expected)
    {
      const int           mine   = static_cast<int>(key.size());
      const Gathered<int> counts = gather_all<int>(triangulation.get_communicator(), std::span<const int>(&mine, 1));
      std::vector<int>    first{0};
      for (const int count : counts.entry)
        first.push_back(first.back() + count);
      if (first.back() != static_cast<int>(expected.size()) ||
          !std::equal(key.begin(), key.end(), expected.begin() + first[rank]))
        throw StateError("the forest has " + std::to_string(first.back()) + " leaves after adaptation; agreed were " +
                         std::to_string(expected.size()) + ", or others");
      all.entry = std::move(expected);
      all.first = std::move(first);
    }

    std::vector<CellKey> key;  ///< this rank's leaves
    std::vector<Cell>    cell; ///< and their cells
    std::vector<Index>   leaf; ///< [active cell index] leaf, `none` where not owned
  };

  template <int dim>
  Forest<dim>::Forest(MPI_Comm communicator, const Lattice<dim> &lattice)
    : implementation_(std::make_unique<Implementation>(communicator, lattice))
  {
  }

  template <int dim>
  Forest<dim>::~Forest() = default;

  template <int dim>
  std::span<const CellKey>
  Forest<dim>::leaves() const
  {
    return implementation_->owned();
  }

  template <int dim>
  std::span<const CellKey>
  Forest<dim>::all_leaves() const
  {
    return implementation_->all.entry;
  }

  template <int dim>
  std::size_t
  Forest<dim>::first_leaf() const
  {
    return implementation_->all.first[implementation_->rank];
  }

  template <int dim>
  const Lattice<dim> &
  Forest<dim>::lattice() const
  {
    return implementation_->lattice;
  }

  template <int dim>
  MPI_Comm
  Forest<dim>::communicator() const
  {
    return implementation_->triangulation.get_communicator();
  }

  template <int dim>
  bool
  Forest<dim>::adapt(std::span<const std::uint8_t> target, std::vector<CellPacket> &packets,
                     const PacketRemap<dim> &remap, const LeafWeight &weight)
  {
    Implementation &forest = *implementation_;
    forest.require_one_each(target.size(), "target levels");
    forest.require_one_each(packets.size(), "packets");

    const Gathered<std::uint8_t>    targets = gather_all<std::uint8_t>(communicator(), target);
    const std::vector<std::uint8_t> level   = agree_levels<dim>(lattice(), all_leaves(), targets.entry);
    std::vector<CellKey>            next    = adapted_leaves<dim>(lattice(), all_leaves(), level);
    if (std::equal(next.begin(), next.end(), all_leaves().begin(), all_leaves().end()))
      return false;

    forest.flag(std::span<const std::uint8_t>(level).subspan(forest.all.first[forest.rank], target.size()));
    forest.change_with_packets(packets, remap, weight, std::move(next),
                               [&] { forest.triangulation.execute_coarsening_and_refinement(); });
    return true;
  }

  template <int dim>
  int
  Forest<dim>::adapt_until(const std::function<std::uint8_t(CellKey leaf)> &target_level,
                           std::vector<CellPacket> &packets, const PacketRemap<dim> &remap, const LeafWeight &weight)
  {
    std::vector<std::uint8_t> target;
    for (int rounds = 0;; ++rounds)
      {
        target.clear();
        for (const CellKey leaf : leaves())
          target.push_back(target_level(leaf));
        if (!adapt(target, packets, remap, weight))
          return rounds;
      }
  }

  template <int dim>
  void
  Forest<dim>::repartition(std::vector<CellPacket> &packets, const LeafWeight &weight)
  {
    Implementation &forest = *implementation_;
    forest.require_one_each(packets.size(), "packets");
    if (forest.all.first.size() > 2) // one rank has nothing to hand over
      forest.change_with_packets(packets, PacketRemap<dim>(), weight, forest.all.entry,
                                 [&] { forest.triangulation.repartition(); });
  }

  template <int dim>
  std::unique_ptr<FlatPartition<dim>>
  Forest<dim>::flatten(const std::vector<std::uint8_t> &active, int halo_width, const Bonds &bonds) const
  {
    return flatten_leaves<dim>(communicator(), lattice(), leaves(), active, halo_width, bonds);
  }

  template class Forest<2>;
} // namespace whipple
