// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/mesh/flat_builder.h>
#include <whipple/mesh/key_index.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace whipple
{
  namespace
  {
    template <int dim>
    std::uint64_t
    point_key(const LatticePoint<dim> &point)
    {
      std::uint64_t key = 0;
      for (int d = 0; d < dim; ++d)
        key |= static_cast<std::uint64_t>(point[d]) << (21 * d);
      return key;
    }

    /// Builds one FlatMesh; the members are what the phases hand to each other.
    template <int dim>
    class Builder
    {
    public:
      Builder(const Lattice<dim> &lattice, FlatMesh<dim> &mesh)
        : lattice_(lattice)
        , mesh_(mesh)
        , any_intact_(std::find(mesh.intact.begin(), mesh.intact.end(), 1) != mesh.intact.end())
        , cell_of_key_(std::span<const CellKey>(mesh.key))
      {
      }

      void
      boxes()
      {
        mesh_.level.resize(mesh_.n_cells);
        mesh_.size.resize(mesh_.n_cells);
        for (auto &lower : mesh_.lower)
          lower.resize(mesh_.n_cells);
        for (Index c = 0; c < mesh_.n_cells; ++c)
          {
            mesh_.level[c] = static_cast<std::uint8_t>(key_level(mesh_.key[c]));
            mesh_.size[c]  = extent(c) * lattice_.spacing;
            for (int d = 0; d < dim; ++d)
              mesh_.lower[d][c] = coordinate(point(c)[d], d);
          }
      }

      void
      nodes()
      {
        mesh_.cell_node.assign(static_cast<std::size_t>(mesh_.n_cells) * corners, none);
        if (any_intact_)
          join_corners();
        else
          std::iota(mesh_.cell_node.begin(), mesh_.cell_node.end(), Index{0});
        for (const Index node : mesh_.cell_node)
          mesh_.n_nodes = std::max(mesh_.n_nodes, node + 1);
        node_geometry();
        node_corners();
      }

      void
      hanging_nodes()
      {
        static_assert(dim == 2, "a hanging node is the middle of an edge in two dimensions");
        for (auto &middle : middle_)
          middle.assign(mesh_.n_cells, none);
        if (!any_intact_)
          return;
        struct Hanging
        {
          std::uint64_t position;
          Index         node;
          Masters<dim>  master;
        };
        std::vector<Hanging> found;
        for (Index c = 0; c < mesh_.n_cells; ++c)
          for (int axis = 0; axis < dim && mesh_.intact[c] && extent(c) > 1; ++axis)
            for (int side = 0; side < 2; ++side)
              {
                const int         along = 1 - axis;
                LatticePoint<dim> mid   = point(c);
                mid[axis] += side * extent(c);
                mid[along] += extent(c) / 2;
                const Index node = fine_corner(c, axis, side, mid);
                if (node == none)
                  continue;
                middle_[2 * axis + side][c] = node;
                const int first             = side << axis;
                found.push_back({point_key<dim>(mid), node, {{{corner(c, first), corner(c, first | (1 << along))}}}});
              }
        std::sort(found.begin(), found.end(),
                  [](const Hanging &a, const Hanging &b) { return a.position < b.position; });
        for (const Hanging &h : found)
          {
            mesh_.hanging.push_back(h.node);
            mesh_.master.push_back(h.master);
          }
      }

      void
      faces()
      {
        for (auto &list : mesh_.cell_face)
          list.assign(static_cast<std::size_t>(mesh_.n_cells) * subfaces, none);
        for (int axis = 0; axis < dim; ++axis)
          for (Index c = 0; c < mesh_.n_cells; ++c)
            for (int side = 0; side < 2 && mesh_.intact[c]; ++side)
              faces_of_side(c, axis, side);
      }

    private:
      static constexpr int corners  = FlatMesh<dim>::corners;
      static constexpr int subfaces = FlatMesh<dim>::subfaces;

      LatticePoint<dim>
      point(Index c) const
      {
        return key_point<dim>(mesh_.key[c]);
      }
      int
      extent(Index c) const
      {
        return lattice_.extent(key_level(mesh_.key[c]));
      }
      double
      coordinate(int i, int axis) const
      {
        return lattice_.origin[axis] + i * lattice_.spacing;
      }
      Index
      corner(Index c, int k) const
      {
        return mesh_.cell_node[static_cast<std::size_t>(c) * corners + k];
      }
      LatticePoint<dim>
      corner_point(Index c, int k) const
      {
        LatticePoint<dim> p = point(c);
        for (int d = 0; d < dim; ++d)
          p[d] += ((k >> d) & 1) * extent(c);
        return p;
      }
      std::string
      describe(Index c) const
      {
        std::string text = "level " + std::to_string(key_level(mesh_.key[c])) + " at";
        for (int d = 0; d < dim; ++d)
          text += " " + std::to_string(coordinate(point(c)[d], d)) + " cm";
        return text;
      }

      /// The intact cell at a level whose box holds the lattice point, `none` if there is no such leaf.
      Index
      cell_at(int level, LatticePoint<dim> p) const
      {
        if (level < 0 || level > lattice_.max_level)
          return none;
        for (int d = 0; d < dim; ++d)
          {
            if (p[d] < 0 || p[d] >= lattice_.finest(d))
              return none;
            p[d] &= ~(lattice_.extent(level) - 1);
          }
        const Index cell = cell_of_key_.find(make_key<dim>(level, p));
        return cell == none || mesh_.intact[cell] ? cell : none;
      }

      /// Corners that meet in a point are one node where a chain of bonded faces joins their cells: two
      /// cells that touch in a corner only keep a node each, and a broken cell keeps all of its own.
      void
      join_corners()
      {
        const std::size_t                       n = mesh_.cell_node.size();
        KeyIndex                                slot_of_point(n);
        std::vector<std::array<Index, corners>> around; // corner entry of each quadrant around a point
        for (Index c = 0; c < mesh_.n_cells; ++c)
          for (int k = 0; k < corners; ++k)
            {
              const CellKey here = point_key<dim>(corner_point(c, k));
              Index         slot = slot_of_point.find(here);
              if (slot == none)
                {
                  slot = static_cast<Index>(around.size());
                  slot_of_point.insert(here, slot);
                  around.emplace_back();
                  around.back().fill(none);
                }
              Index &entry = around[slot][corners - 1 - k];
              if (entry != none)
                throw StateError("flat mesh: leaves overlap at " + describe(c));
              entry = c * corners + k;
            }
        Index next = 0;
        for (const auto &quadrant : around)
          for (int q = 0; q < corners; ++q)
            if (quadrant[q] != none && mesh_.cell_node[quadrant[q]] == none)
              {
                if (mesh_.intact[quadrant[q] / corners])
                  flood(quadrant, q, next++);
                else
                  mesh_.cell_node[quadrant[q]] = next++;
              }
      }

      void
      flood(const std::array<Index, corners> &quadrant, int q, Index node)
      {
        mesh_.cell_node[quadrant[q]] = node;
        for (int d = 0; d < dim; ++d)
          {
            const int next = q ^ (1 << d);
            if (quadrant[next] != none && mesh_.cell_node[quadrant[next]] == none &&
                mesh_.intact[quadrant[next] / corners])
              flood(quadrant, next, node);
          }
      }

      void
      node_geometry()
      {
        for (auto &x : mesh_.node_point)
          x.resize(mesh_.n_nodes);
        mesh_.node_side.assign(mesh_.n_nodes, 0);
        for (Index c = 0; c < mesh_.n_cells; ++c)
          for (int k = 0; k < corners; ++k)
            for (int d = 0; d < dim; ++d)
              {
                const int i                       = corner_point(c, k)[d];
                mesh_.node_point[d][corner(c, k)] = coordinate(i, d);
                mesh_.node_side[corner(c, k)] |=
                    static_cast<std::uint8_t>(((i == 0) << (2 * d)) | ((i == lattice_.finest(d)) << (2 * d + 1)));
              }
      }

      /// CSR of corners, ordered by the quadrant the cell has around the node.
      void
      node_corners()
      {
        mesh_.node_corner_begin.assign(mesh_.n_nodes + 1, 0);
        for (const Index node : mesh_.cell_node)
          ++mesh_.node_corner_begin[node + 1];
        std::partial_sum(mesh_.node_corner_begin.begin(), mesh_.node_corner_begin.end(),
                         mesh_.node_corner_begin.begin());
        mesh_.node_corner.resize(mesh_.cell_node.size());
        std::vector<Index> next(mesh_.node_corner_begin.begin(), mesh_.node_corner_begin.end());
        for (int k = corners - 1; k >= 0; --k)
          for (Index c = 0; c < mesh_.n_cells; ++c)
            mesh_.node_corner[next[corner(c, k)]++] = c * corners + k;
      }

      /// Node of the finer cells across a side of c that sits in the middle of it, `none` without such cells.
      Index
      fine_corner(Index c, int axis, int side, LatticePoint<dim> mid) const
      {
        LatticePoint<dim> inside = mid;
        inside[axis] -= 1 - side;
        const int level = key_level(mesh_.key[c]) + 1;
        for (int half = 0; half < 2; ++half)
          {
            LatticePoint<dim> p = inside;
            p[1 - axis] -= 1 - half;
            const Index fine = cell_at(level, p);
            if (fine != none)
              return corner(fine, ((1 - side) << axis) | ((1 - half) << (1 - axis)));
          }
        return none;
      }

      void
      add_face(int axis, std::array<Index, 2> cell, std::array<int, 2> part, std::array<Index, subfaces> node, int side)
      {
        FlatFaces<dim> &faces = mesh_.faces[axis];
        const Index     f     = faces.size();
        for (int s = 0; s < 2; ++s)
          {
            faces.cell[s].push_back(cell[s]);
            faces.part[s].push_back(static_cast<std::int8_t>(part[s]));
            if (cell[s] != none)
              mesh_.cell_face[2 * axis + (1 - s)][static_cast<std::size_t>(cell[s]) * subfaces + std::max(part[s], 0)] =
                  f;
          }
        faces.node.insert(faces.node.end(), node.begin(), node.end());
        faces.side.push_back(static_cast<std::int8_t>(side));
      }

      /// Nodes of a whole side of a cell, or of one half of it when its middle hangs.
      std::array<Index, subfaces>
      side_nodes(Index c, int axis, int side, int part) const
      {
        const int                   along = 1 - axis, first = side << axis;
        std::array<Index, subfaces> node{{corner(c, first), corner(c, first | (1 << along))}};
        if (part >= 0)
          node[1 - part] = middle_[2 * axis + side][c];
        return node;
      }

      /// Enter the faces on one side of a cell: those towards an upper neighbour, and those without one.
      void
      faces_of_side(Index c, int axis, int side)
      {
        const int         level = key_level(mesh_.key[c]);
        LatticePoint<dim> next  = point(c);
        next[axis] += side ? extent(c) : -1;
        const bool at_domain_side = next[axis] < 0 || next[axis] >= lattice_.finest(axis);
        const auto ordered        = [side](Index own, Index other) {
          return side ? std::array<Index, 2>{{own, other}} : std::array<Index, 2>{{other, own}};
        };
        const auto parts = [side](int own, int other) {
          return side ? std::array<int, 2>{{own, other}} : std::array<int, 2>{{other, own}};
        };

        if (const Index same = cell_at(level, next); same != none)
          {
            if (side)
              add_face(axis, {{c, same}}, {{-1, -1}}, side_nodes(c, axis, 1, -1), -1);
          }
        else if (const Index coarse = cell_at(level - 1, next); coarse != none)
          {
            const int half = (point(c)[1 - axis] / extent(c)) & 1;
            if (side)
              add_face(axis, {{c, coarse}}, {{-1, half}}, side_nodes(c, axis, 1, -1), -1);
            else
              // the coarse cell is the lower one here and cannot know both halves: each fine cell enters its own
              add_face(axis, {{coarse, c}}, {{half, -1}}, side_nodes(c, axis, 0, -1), -1);
          }
        else if (middle_[2 * axis + side][c] == none)
          {
            if (cell_at(level - 2, next) != none)
              throw StateError("flat mesh: leaves out of 2:1 balance at " + describe(c));
            add_face(axis, ordered(c, none), parts(-1, -1), side_nodes(c, axis, side, -1),
                     at_domain_side ? 2 * axis + side : -1);
          }
        else // finer neighbours enter their own halves; a half without one ends here
          for (int half = 0; half < 2; ++half)
            {
              LatticePoint<dim> p = next;
              p[1 - axis] += half * extent(c) / 2;
              if (cell_at(level + 1, p) == none)
                add_face(axis, ordered(c, none), parts(half, -1), side_nodes(c, axis, side, half), -1);
            }
      }

      const Lattice<dim>                     &lattice_;
      FlatMesh<dim>                          &mesh_;
      bool                                    any_intact_;
      KeyIndex                                cell_of_key_;
      std::array<std::vector<Index>, 2 * dim> middle_; ///< [side][cell] hanging node in the middle of the side
    };
  } // namespace

  template <int dim>
  FlatMesh<dim>
  build_flat_mesh(const Lattice<dim> &lattice, std::vector<CellKey> keys, Index n_owned,
                  std::vector<std::uint8_t> layer, int halo_width, const Bonds &bonds)
  {
    FlatMesh<dim> mesh;
    mesh.symmetry   = lattice.symmetry;
    mesh.n_owned    = n_owned;
    mesh.n_cells    = static_cast<Index>(keys.size());
    mesh.halo_width = halo_width;
    mesh.key        = std::move(keys);
    mesh.layer      = std::move(layer);
    bonds.require_size(mesh.n_cells);
    mesh.intact.resize(mesh.n_cells);
    for (Index c = 0; c < mesh.n_cells; ++c)
      mesh.intact[c] = bonds.intact(c);

    Builder<dim> builder(lattice, mesh);
    builder.boxes();
    builder.nodes();
    builder.hanging_nodes();
    builder.faces();
    return mesh;
  }

  template FlatMesh<2>
  build_flat_mesh(const Lattice<2> &, std::vector<CellKey>, Index, std::vector<std::uint8_t>, int, const Bonds &);
} // namespace whipple
