// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/plate_surfaces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// The middle of the plate beside an edge is taken from columns this far from it, in thicknesses of the plate:
    /// behind the lips, before the dish bends.
    constexpr double beside_from = 1., beside_to = 3.;

    /// A plate is not taken for thinner than this many cells there.
    constexpr double fewest_cells = 2.;

    /// A cell filled to this share is not cut by the faces of the plate.
    constexpr double uncut = 0.9;

    /// A straight line z(x).
    struct Line
    {
      double x = 0, z = 0, slope = 0;

      double
      at(double position) const
      {
        return z + slope * (position - x);
      }
    };

    /// Least squares through the middles of the columns.
    Line
    line_through(const std::vector<PlateColumn> &columns)
    {
      Line line;
      for (const PlateColumn &c : columns)
        {
          line.x += c.x / columns.size();
          line.z += c.middle() / columns.size();
        }
      double xx = 0, xz = 0;
      for (const PlateColumn &c : columns)
        {
          xx += (c.x - line.x) * (c.x - line.x);
          xz += (c.x - line.x) * (c.middle() - line.z);
        }
      line.slope = xx > 0 ? xz / xx : 0.;
      return line;
    }

    /// Where the upper `share` of the interval [a, b] begins; by volume of revolution about 0 if `round`.
    double
    upper_part(double a, double b, double share, bool round)
    {
      return round ? std::sqrt(std::max(b * b - share * (b * b - a * a), 0.)) : b - share * (b - a);
    }
  } // namespace

  std::optional<double>
  PlateSurfaces::surface(int piece, int axis, int line, bool from_below) const
  {
    const std::vector<PlateCell> &cells  = image_.cells();
    const std::span<const int>    all    = image_.line(axis, line);
    const int                     n      = static_cast<int>(all.size());
    const int                     step   = from_below ? 1 : -1;
    int                           k      = from_below ? 0 : n - 1;
    const auto                    exists = [n](int i) { return i >= 0 && i < n; };
    while (exists(k) && pieces_.piece[all[k]] != piece)
      k += step;
    if (!exists(k))
      return std::nullopt;

    const auto touches = [&](int i, int j) {
      return cells[all[std::min(i, j)]].upper(axis) == cells[all[std::max(i, j)]].lower[axis];
    };
    const auto ours    = [&](int i) { return pieces_.piece[all[i]] == piece || pieces_.skin[all[i]]; };
    const bool follows = exists(k + step) && touches(k, k + step) && ours(k + step);
    const bool before  = exists(k - step) && touches(k, k - step) && pieces_.skin[all[k - step]];

    // what a cell holds lies on the inner side of it; along a row full is what its inner neighbour is, and if that is
    // cut by the faces of the plate, where the first cell is cut cannot be told
    const PlateCell &first = cells[all[k]];
    const double     full  = axis == 1 ? 1. : std::max(first.fill, follows ? cells[all[k + step]].fill : 0.);
    if (full < uncut)
      return std::nullopt;
    const bool round = axis == 0 && from_below && site_.symmetry == Symmetry::axisymmetric;
    const auto place = [&](int coordinate) { return site_.origin[axis] + coordinate * site_.spacing; };
    const auto depth = [&](const PlateCell &cell) {
      const double a = place(cell.lower[axis]), b = place(cell.upper(axis));
      return b - upper_part(a, b, std::min(cell.fill / full, 1.), round);
    };
    double inner = depth(first);
    if (axis == 1 && !follows) // a layer inside one cell: on the side where there is more of it, else in the middle
      inner = before ? first.size * site_.spacing : 0.5 * (inner + first.size * site_.spacing);
    const double total = inner + (before ? depth(cells[all[k - step]]) : 0.);
    return from_below ? place(first.upper(axis)) - total : place(first.lower[axis]) + total;
  }

  double
  PlateSurfaces::solid_on(int piece, int column) const
  {
    double length = 0;
    for (const int c : image_.line(1, column))
      if (pieces_.piece[c] == piece || pieces_.skin[c])
        length += image_.cells()[c].solid * image_.cells()[c].size;
    return length * site_.spacing;
  }

  std::vector<PlateColumn>
  PlateSurfaces::columns(int piece) const
  {
    std::vector<PlateColumn> result;
    const auto [first, last] = image_.lines(1);
    for (int k = first; k < last; ++k)
      if (const auto front = surface(piece, 1, k, true))
        result.push_back(
            {site_.origin[0] + (k + 0.5) * site_.spacing, *front, *surface(piece, 1, k, false), solid_on(piece, k)});
    return result;
  }

  double
  PlateSurfaces::tip(int piece, bool from_left) const
  {
    const int step         = from_left ? 1 : -1;
    const auto [low, high] = image_.lines(1);
    const auto holds       = [&](int column) {
      const std::span<const int> line = image_.line(1, column);
      return std::any_of(line.begin(), line.end(), [&](int c) { return pieces_.piece[c] == piece; });
    };
    int first = from_left ? low : high - 1;
    while (!holds(first))
      first += step;

    // how much of the first column, and of the skin before it, is filled as its inner neighbour is
    const double here  = solid_on(piece, first);
    const double full  = holds(first + step) ? std::max(here, solid_on(piece, first + step)) : here;
    const bool   round = from_left && site_.symmetry == Symmetry::axisymmetric;
    const auto   depth = [&](int column) {
      const double a = site_.origin[0] + column * site_.spacing;
      return a + site_.spacing - upper_part(a, a + site_.spacing, std::min(solid_on(piece, column) / full, 1.), round);
    };
    const double total = depth(first) + depth(first - step);
    double tip = site_.origin[0] + (from_left ? (first + 1) * site_.spacing - total : first * site_.spacing + total);
    const auto [row, end] = image_.lines(0);
    for (int j = row; j < end; ++j)
      if (const auto x = edge(piece, j, from_left))
        tip = from_left ? std::min(tip, *x) : std::max(tip, *x);
    return tip;
  }

  Vector<2>
  PlateSurfaces::middle_of_edge(int piece, bool from_left) const
  {
    std::vector<PlateColumn> all = columns(piece), beside;
    if (!from_left)
      std::reverse(all.begin(), all.end());
    const double edge_tip = tip(piece, from_left);
    const double scale    = std::max(site_.plate.thickness, fewest_cells * site_.spacing);
    for (const PlateColumn &c : all)
      if (std::abs(c.x - edge_tip) >= beside_from * scale && std::abs(c.x - edge_tip) <= beside_to * scale)
        beside.push_back(c);
    if (beside.size() < 2) // a narrow rest: all of it
      beside = all;
    const Line middle = line_through(beside);

    // along the edge near its tip, from front to rear: where it crosses that line, else comes nearest to it
    Vector<2>                best{{edge_tip, middle.at(edge_tip)}};
    double                   distance = std::numeric_limits<double>::infinity(), closest = distance;
    bool                     crosses = false;
    std::optional<Vector<2>> last;
    const auto               above = [&](const Vector<2> &x) { return x[1] - middle.at(x[0]); };
    const auto [first, end]        = image_.lines(0);
    for (int row = first; row < end; ++row)
      {
        const auto x = edge(piece, row, from_left);
        if (!x || std::abs(*x - edge_tip) > scale)
          {
            last.reset();
            continue;
          }
        const Vector<2> here{{*x, row_middle(row)}};
        if (last && (above(*last) < 0) != (above(here) < 0))
          {
            const double    part = above(*last) / (above(*last) - above(here));
            const Vector<2> crossing{
                {(*last)[0] + part * (here[0] - (*last)[0]), (*last)[1] + part * (here[1] - (*last)[1])}};
            if (std::abs(crossing[0] - edge_tip) < distance)
              {
                best     = crossing;
                distance = std::abs(crossing[0] - edge_tip);
                crosses  = true;
              }
          }
        if (!crosses && std::abs(above(here)) < closest)
          {
            best    = here;
            closest = std::abs(above(here));
          }
        last = here;
      }
    return best;
  }

  double
  PlateSurfaces::gap() const
  {
    const std::vector<PlateCell> &cells = image_.cells();
    double                        least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 2; ++axis)
      {
        const auto [first, last] = image_.lines(axis);
        for (int line = first; line < last; ++line)
          {
            int    before  = none;
            double between = 0; // held by the skins between two cells of the pieces
            for (const int c : image_.line(axis, line))
              {
                const PlateCell &cell = cells[c];
                if (pieces_.skin[c])
                  between += cell.fill * cell.size;
                if (!pieces_.attached(c))
                  continue;
                if (before != none && pieces_.piece[before] != pieces_.piece[c])
                  {
                    const PlateCell &a = cells[before];
                    least = std::min(least, cell.upper(axis) - a.lower[axis] - cell.fill * cell.size - a.fill * a.size -
                                                between);
                  }
                before  = c;
                between = 0;
              }
          }
      }
    return std::max(least, 0.) * site_.spacing;
  }
} // namespace whipple
