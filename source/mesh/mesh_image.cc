// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/gather.h>
#include <whipple/mesh/key_arithmetic.h>
#include <whipple/mesh/key_index.h>
#include <whipple/mesh/mesh_image.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// Levels that lead a forest to wanted leaves.
    template <int dim>
    class Targets
    {
    public:
      Targets(const Lattice<dim> &lattice, const std::vector<CellKey> &wanted)
        : wanted_(wanted)
        , above_(wanted.size())
      {
        for (const CellKey leaf : wanted)
          for (int level = key_level(leaf) - 1; level >= 0; --level)
            {
              const std::size_t before = above_.size();
              above_.insert(ancestor_key(lattice, leaf, level), 0);
              if (above_.size() == before)
                break; // and so are those above it
            }
      }

      std::uint8_t
      operator()(CellKey leaf) const
      {
        const int level = key_level(leaf);
        return static_cast<std::uint8_t>(wanted_.contains(leaf)  ? level
                                         : above_.contains(leaf) ? level + 1
                                                                 : level - 1);
      }

    private:
      KeyIndex wanted_, above_;
    };

    /// Work of a leaf for the partition: nearly all of it lies in the active ones.
    unsigned int
    weight_of(const CellPacket &packet)
    {
      constexpr unsigned int active = 1000;
      return packet.empty() ? 1u : active;
    }

    /// This rank's part of what there is one of for every leaf.
    template <int dim>
    std::vector<std::uint8_t>
    own_part(const Forest<dim> &forest, const std::vector<std::uint8_t> &all)
    {
      const auto first = all.begin() + forest.first_leaf();
      return {first, first + forest.leaves().size()};
    }
  } // namespace

  std::size_t
  MeshImage::n_active() const
  {
    return static_cast<std::size_t>(
        std::count_if(active.begin(), active.end(), [](std::uint8_t flag) { return flag != 0; }));
  }

  template <int dim>
  MeshImage
  image_of(const Forest<dim> &forest, const FlatPartition<dim> &view)
  {
    std::vector<std::uint8_t> active(forest.leaves().size(), 0), intact(active.size(), 0);
    for (Index c = 0; c < view.mesh.n_owned; ++c)
      {
        active[view.leaf_of_cell[c]] = 1;
        intact[view.leaf_of_cell[c]] = view.mesh.intact[c];
      }
    const auto everywhere = [&](const std::vector<std::uint8_t> &own) {
      return gather_all<std::uint8_t>(forest.communicator(), own).entry;
    };
    return {{forest.all_leaves().begin(), forest.all_leaves().end()},
            everywhere(active),
            everywhere(intact),
            view.mesh.halo_width};
  }

  template <int dim>
  std::unique_ptr<FlatPartition<dim>>
  rebuild(const MeshImage &image, Forest<dim> &forest)
  {
    const Targets<dim>        targets(forest.lattice(), image.leaf);
    std::vector<CellPacket>   packets(forest.leaves().size());
    const int                 most_rounds = 2 * forest.lattice().max_level + 1;
    std::vector<std::uint8_t> target;
    bool                      changed = true;
    for (int round = 0; changed && round < most_rounds; ++round)
      {
        target.clear();
        for (const CellKey leaf : forest.leaves())
          target.push_back(targets(leaf));
        changed = forest.adapt(target, packets, PacketRemap<dim>{});
      }
    if (!std::equal(image.leaf.begin(), image.leaf.end(), forest.all_leaves().begin(), forest.all_leaves().end()))
      throw StateError("the " + std::to_string(image.leaf.size()) +
                       " leaves to rebuild are none of a balanced forest over this lattice");

    const std::vector<std::uint8_t> heavy = own_part(forest, image.active);
    for (std::size_t i = 0; i < heavy.size(); ++i)
      packets[i] = heavy[i] ? CellPacket{1.} : CellPacket{}; // a packet of one number marks it
    forest.repartition(packets, weight_of);
    return forest.flatten(own_part(forest, image.active), image.halo_width, Bonds(own_part(forest, image.intact)));
  }

  template MeshImage
  image_of(const Forest<2> &, const FlatPartition<2> &);
  template std::unique_ptr<FlatPartition<2>>
  rebuild(const MeshImage &, Forest<2> &);
} // namespace whipple
