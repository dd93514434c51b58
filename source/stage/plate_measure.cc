// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/stage/plate_measure.h>
#include <whipple/stage/plate_surfaces.h>

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

    /// Width of the plate as it entered, as a hole's diameter is measured, cm.
    double
    whole_width(const PlateSite &site)
    {
      const double right = std::min(site.plate.half_width, site.right());
      if (site.half)
        return 2. * (right - (site.symmetry == Symmetry::axisymmetric ? 0. : site.left()));
      return right - std::max(-site.plate.half_width, site.left());
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
      std::vector<PlateColumn> columns = surfaces.columns(pieces.right);
      if (pieces.left != none && pieces.left != pieces.right)
        {
          const std::vector<PlateColumn> more = surfaces.columns(pieces.left);
          columns.insert(columns.begin(), more.begin(), more.end());
        }
      const long from_left = site.half || site.reaches_left() ? 0 : cut, from_right = site.reaches_right() ? 0 : cut;
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
      if (!site.half)
        return pieces.left == pieces.right;
      const std::span<const int> first = image.line(1, 0);
      return std::any_of(first.begin(), first.end(), [&](int c) { return pieces.piece[c] == pieces.right; });
    }

    void
    measure_hole(const PlateSite &site, const PlatePieces &pieces, const PlateSurfaces &surfaces, PlateMeasure &result)
    {
      const double    end  = surfaces.tip(pieces.right, true);
      const Vector<2> edge = surfaces.middle_of_edge(pieces.right, true);
      if (site.half)
        {
          const double line             = site.symmetry == Symmetry::axisymmetric ? 0. : site.left();
          result.hole_diameter          = 2. * (edge[0] - line);
          result.smallest_hole_diameter = 2. * (end - line);
          result.perforation_margin     = result.smallest_hole_diameter;
          return;
        }
      const double    other_end     = surfaces.tip(pieces.left, false);
      const Vector<2> other         = surfaces.middle_of_edge(pieces.left, false);
      result.hole_diameter          = std::hypot(edge[0] - other[0], edge[1] - other[1]);
      result.smallest_hole_diameter = std::max(end - other_end, 0.);
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
    if (pieces.right == none || (!site.half && pieces.left == none)) // shattered all over
      {
        result.hole_diameter = result.smallest_hole_diameter = result.perforation_margin = whole_width(site);
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
