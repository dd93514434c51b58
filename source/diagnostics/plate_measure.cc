// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/plate_measure.h>
#include <whipple/diagnostics/plate_surfaces.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// Part of a plate's mass below which nothing of it is left to be measured.
    constexpr double nothing_left = 0.01;

    /// Part of a plate's width, at its rims, from which its undisturbed planes are taken.
    constexpr double rim_zone = 0.2;

    /// Columns at a free rim that are the rim's own surface.
    constexpr double rim_columns = 2., rim_thicknesses = 0.5;

    /// Whether most of the plate lies in cells larger than its thickness.
    bool
    too_coarse(const PlateSite &site, const std::vector<PlateCell> &cells)
    {
      double dense = 0, coarse = 0;
      for (const PlateCell &cell : cells)
        if (cell.dense)
          {
            dense += cell.mass;
            if (cell.size * site.spacing > (1. + 1e-9) * site.plate.thickness)
              coarse += cell.mass;
          }
      return coarse > 0.5 * dense;
    }

    /// Where the diameter of a hole in half a plate is measured from, cm.
    double
    line_of_symmetry(const PlateSite &site)
    {
      return site.symmetry == Symmetry::axisymmetric ? 0. : site.left();
    }

    double
    median(std::vector<double> values)
    {
      std::sort(values.begin(), values.end());
      const std::size_t n = values.size();
      return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
    }

    /// The plane of one of the plate's faces far from the impact: level in half a plate, else through both rims.
    struct Plane
    {
      double x = 0, z = 0, slope = 0;

      double
      at(double position) const
      {
        return z + slope * (position - x);
      }
    };

    Plane
    undisturbed_plane(const PlateSite &site, const std::vector<PlateColumn> &columns, double PlateColumn::*face)
    {
      const std::size_t zone = std::max<std::size_t>(1, static_cast<std::size_t>(rim_zone * columns.size()));
      const auto        rim  = [&](std::size_t begin) {
        std::vector<double> x, z;
        for (std::size_t i = begin; i < begin + zone; ++i)
          {
            x.push_back(columns[i].x);
            z.push_back(columns[i].*face);
          }
        return std::array<double, 2>{{median(x), median(z)}};
      };
      const auto right = rim(columns.size() - zone);
      if (site.half)
        return {right[0], right[1], 0.};
      const auto left = rim(0);
      return {left[0], left[1], right[0] > left[0] ? (right[1] - left[1]) / (right[0] - left[0]) : 0.};
    }

    /// The columns of all that is attached, without those that a free rim cuts.
    std::vector<PlateColumn>
    columns_inside_rims(const PlateSite &site, const PlatePieces &pieces, const PlateSurfaces &surfaces)
    {
      const auto cut =
          static_cast<long>(std::ceil(std::max(rim_columns, rim_thicknesses * site.plate.thickness / site.spacing)));
      std::vector<PlateColumn> columns;
      if (pieces.left != none)
        columns = surfaces.columns(pieces.left);
      if (pieces.right != none && pieces.right != pieces.left)
        {
          const std::vector<PlateColumn> more = surfaces.columns(pieces.right);
          columns.insert(columns.end(), more.begin(), more.end());
        }
      const long from_left = site.reaches(0) ? 0 : cut, from_right = site.reaches(1) ? 0 : cut;
      if (static_cast<long>(columns.size()) > from_left + from_right)
        {
          columns.erase(columns.end() - from_right, columns.end());
          columns.erase(columns.begin(), columns.begin() + from_left);
        }
      return columns;
    }

    /// Whether the attached material reaches from the left rim, or the line of symmetry, to the right rim in one piece.
    bool
    is_barred(const PlateSite &site, const PlateImage &image, const PlatePieces &pieces)
    {
      if (pieces.right == none)
        return false;
      if (!site.half)
        return pieces.left == pieces.right;
      const std::span<const int> first = image.line(1, 0);
      return std::any_of(first.begin(), first.end(), [&](int c) { return pieces.piece[c] == pieces.right; });
    }

    /// One side of a hole.
    struct HoleSide
    {
      double    tip;    ///< cm, how far it reaches into the hole
      Vector<2> middle; ///< where it meets the middle of the plate beside it
    };

    HoleSide
    hole_side(const PlateSurfaces &surfaces, int piece, bool from_left)
    {
      return {surfaces.tip(piece, from_left), surfaces.middle_of_edge(piece, from_left)};
    }

    void
    measure_hole(const PlateSite &site, const PlatePieces &pieces, const PlateSurfaces &surfaces, PlateMeasure &result)
    {
      if (site.half)
        {
          const double   line           = line_of_symmetry(site);
          const HoleSide edge           = hole_side(surfaces, pieces.right, true);
          result.hole_diameter          = 2. * (edge.middle[0] - line);
          result.smallest_hole_diameter = 2. * (edge.tip - line);
          result.perforation_margin     = result.smallest_hole_diameter;
          return;
        }
      // where a rim is lost the hole reaches as far as the plate did
      const auto side = [&](int piece, int other, bool from_left) -> HoleSide {
        if (piece != none)
          return hole_side(surfaces, piece, from_left);
        const double rim = site.rim(from_left ? 1 : 0);
        return {rim, {{rim, hole_side(surfaces, other, !from_left).middle[1]}}};
      };
      const HoleSide right = side(pieces.right, pieces.left, true), left = side(pieces.left, pieces.right, false);
      result.hole_diameter          = std::hypot(right.middle[0] - left.middle[0], right.middle[1] - left.middle[1]);
      result.smallest_hole_diameter = std::max(right.tip - left.tip, 0.);
      result.perforation_margin = result.smallest_hole_diameter > 0 ? result.smallest_hole_diameter : surfaces.gap();
    }
  } // namespace

  std::optional<PlateMeasure>
  measure_plate(const PlateSite &site, std::vector<PlateCell> cells)
  {
    const PlateImage image(std::move(cells));
    double           mass = 0;
    for (const PlateCell &cell : image.cells())
      mass += cell.mass;
    if (site.plate.thickness < (1. - 1e-9) * site.spacing || !(mass > nothing_left * site.mass) ||
        too_coarse(site, image.cells()))
      return std::nullopt;

    const PlatePieces pieces = plate_pieces(site, image);
    PlateMeasure      result;
    for (std::size_t c = 0; c < image.cells().size(); ++c)
      if (!pieces.attached(static_cast<int>(c)) && !pieces.skin[c])
        result.detached_mass += image.cells()[c].mass;

    result.perforated = true;
    if (pieces.right == none && pieces.left == none) // shattered all over: as wide as the plate was
      {
        const double width   = site.half ? 2. * (site.rim(1) - line_of_symmetry(site)) : site.rim(1) - site.rim(0);
        result.hole_diameter = result.smallest_hole_diameter = result.perforation_margin = width;
        result.crater_depth                                                              = site.plate.thickness;
        return result;
      }

    const PlateSurfaces            surfaces(site, image, pieces);
    const std::vector<PlateColumn> columns = columns_inside_rims(site, pieces, surfaces);
    const Plane                    front   = undisturbed_plane(site, columns, &PlateColumn::front);
    const Plane                    rear    = undisturbed_plane(site, columns, &PlateColumn::rear);
    result.least_thickness                 = columns.front().thickness;
    for (const PlateColumn &c : columns)
      {
        result.crater_depth    = std::max(result.crater_depth, c.front - front.at(c.x));
        result.front_lip       = std::max(result.front_lip, front.at(c.x) - c.front);
        result.rear_bulge      = std::max(result.rear_bulge, c.rear - rear.at(c.x));
        result.least_thickness = std::min(result.least_thickness, c.thickness);
      }
    if (is_barred(site, image, pieces))
      {
        result.perforated         = false;
        result.perforation_margin = -result.least_thickness;
        return result;
      }
    result.crater_depth    = site.plate.thickness;
    result.least_thickness = 0;
    measure_hole(site, pieces, surfaces, result);
    return result;
  }
} // namespace whipple
