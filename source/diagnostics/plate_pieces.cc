// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/plate_pieces.h>
#include <whipple/mesh/disjoint_sets.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// A cell is solid from this share on.
    constexpr double half_solid = 0.5;

    /// A layer too thin for a half-solid cell shows as a short line of cells with some solid each; together they hold
    /// at least half a cell.
    constexpr double      some_solid = 0.05;
    constexpr std::size_t short_line = 4;

    /// Part of a plate's mass that a piece without hold on a side of the domain must have to be a rim of it.
    constexpr double rim_mass = 0.15;

    /// Part of its thickness over which a plate that is still held by a side of the domain touches it.
    constexpr double rim_contact = 0.5;

    /// Part of the plate's width by which it may have drawn back from a side that it reached.
    constexpr double rim_distance = 0.25;

    /// Mark the cells of thin layers across an axis.
    void
    mark_thin(const PlateImage &image, int axis, std::vector<bool> &solid)
    {
      const std::vector<PlateCell> &cells = image.cells();
      const auto [first, last]            = image.lines(axis);
      for (int k = first; k < last; ++k)
        {
          const std::span<const int> line = image.line(axis, k);
          for (std::size_t begin = 0, end = 0; begin < line.size(); begin = std::max(end, begin + 1))
            {
              double content = 0, most = 0;
              int    largest = 0;
              for (end = begin; end < line.size(); ++end)
                {
                  const PlateCell &cell = cells[line[end]];
                  if (!cell.dense || cell.solid < some_solid ||
                      (end > begin && cells[line[end - 1]].upper(axis) != cell.lower[axis]))
                    break;
                  content += cell.solid * cell.size;
                  most    = std::max(most, cell.solid);
                  largest = std::max(largest, cell.size);
                }
              if (end - begin <= short_line && most < half_solid && largest > 0 && content >= half_solid * largest)
                for (std::size_t i = begin; i < end; ++i)
                  solid[line[i]] = true;
            }
        }
    }

    /// What is known of a piece, under the index of its smallest cell.
    struct Piece
    {
      double                mass = 0;
      std::array<double, 2> contact{}; ///< solid on the first and last column of the domain, finest cells
      std::array<int, 2>    reach{};   ///< how far it reaches to the left and right, finest cells from the left end
    };

    /// The piece that holds the plate's rim on side 0 (left) or 1 (right).
    int
    rim_piece(const PlateSite &site, const std::vector<Piece> &pieces, int side)
    {
      int          best   = none;
      const bool   held   = site.reaches(side);
      const double length = rim_contact * site.plate.thickness / site.spacing;
      if (held)
        for (std::size_t p = 0; p < pieces.size(); ++p)
          if (pieces[p].contact[side] >= length && (best == none || pieces[p].mass > pieces[best].mass))
            best = static_cast<int>(p);
      if (best != none)
        return best;

      // how far outwards on that side, cm
      const auto   outwards = [&](double x) { return side == 0 ? -x : x; };
      const auto   reach    = [&](const Piece &p) { return outwards(site.left() + p.reach[side] * site.spacing); };
      const double near     = outwards(rim_distance * site.rim(1 - side) + (1. - rim_distance) * site.rim(side));
      for (std::size_t p = 0; p < pieces.size(); ++p)
        if (pieces[p].mass > 0 && pieces[p].mass >= rim_mass * site.mass && (!held || reach(pieces[p]) >= near) &&
            (best == none || reach(pieces[p]) > reach(pieces[best])))
          best = static_cast<int>(p);
      return best;
    }
  } // namespace

  PlatePieces
  plate_pieces(const PlateSite &site, const PlateImage &image)
  {
    const std::vector<PlateCell> &cells = image.cells();
    const int                     n     = static_cast<int>(cells.size());
    std::vector<bool>             solid(n);
    for (int c = 0; c < n; ++c)
      solid[c] = cells[c].dense && cells[c].solid >= half_solid;
    for (int axis = 0; axis < 2; ++axis)
      mark_thin(image, axis, solid);

    DisjointSets joined(n);
    image.for_each_contact([&](int a, int b) {
      if (solid[a] && solid[b])
        joined.unite(a, b);
    });

    PlatePieces        result{std::vector<int>(n, none), std::vector<bool>(n, false)};
    std::vector<Piece> pieces(n);
    for (int c = 0; c < n; ++c)
      if (solid[c])
        {
          const PlateCell &cell = cells[c];
          result.piece[c]       = static_cast<int>(joined.root(c));
          Piece &piece          = pieces[result.piece[c]];
          piece.reach           = piece.mass == 0 ? std::array<int, 2>{{cell.lower[0], cell.upper(0)}}
                                                  : std::array<int, 2>{{std::min(piece.reach[0], cell.lower[0]),
                                                                        std::max(piece.reach[1], cell.upper(0))}};
          piece.mass += cell.mass;
          if (cell.lower[0] == 0)
            piece.contact[0] += cell.solid * cell.size;
          if (cell.upper(0) == site.columns)
            piece.contact[1] += cell.solid * cell.size;
        }
    result.left  = site.half ? none : rim_piece(site, pieces, 0);
    result.right = rim_piece(site, pieces, 1);

    image.for_each_contact([&](int a, int b) {
      for (const auto &[inner, outer] : {std::pair{a, b}, std::pair{b, a}})
        if (result.attached(inner) && result.piece[outer] == none && cells[outer].dense)
          result.skin[outer] = true;
    });
    return result;
  }
} // namespace whipple
