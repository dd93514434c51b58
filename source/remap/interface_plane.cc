// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/interface_plane.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace whipple::interface_plane
{
  namespace
  {
    /// A box and a plane seen from the corner where the material is: both components of the normal >= 0, so that
    /// the height of the material over the first axis, y(x) = clamp((offset - n0 x) / n1, 0, b), falls monotonely.
    struct CornerView
    {
      double n0, n1;        ///< normal, both >= 0
      double a, b;          ///< edges of the box
      double weight, slope; ///< measure of length in x: weight + slope x (1 in planar, 2 pi r in axisymmetry)
      double shift;         ///< to be added to an offset measured from the lower corner of the box
    };

    struct Measure
    {
      double volume;     ///< true volume below the plane
      double derivative; ///< d volume / d offset
    };

    CornerView
    corner_view(const Symmetry symmetry, const Vector<2> &lower, const Vector<2> &upper, const Vector<2> &normal)
    {
      CornerView view{std::abs(normal[0]), std::abs(normal[1]), upper[0] - lower[0], upper[1] - lower[1], 1., 0., 0.};
      const bool mirrored = normal[0] < 0;
      if (symmetry == Symmetry::axisymmetric)
        {
          view.weight = 2. * std::numbers::pi * (mirrored ? upper[0] : lower[0]);
          view.slope  = 2. * std::numbers::pi * (mirrored ? -1. : 1.);
        }
      if (mirrored)
        view.shift += view.n0 * view.a;
      if (normal[1] < 0)
        view.shift += view.n1 * view.b;
      return view;
    }

    /// Volume of the whole box.
    double
    box_volume(const CornerView &view)
    {
      return view.a * view.b * (view.weight + 0.5 * view.slope * view.a);
    }

    /// Volume under the height function: a full slab up to where the plane leaves the top of the box, then a
    /// trapezoid. All terms are positive, so nothing cancels however the plane lies.
    Measure
    measure(const CornerView &view, const double offset)
    {
      const auto [n0, n1, a, b, weight, slope, shift] = view;
      if (offset <= 0)
        return {0., 0.};
      if (offset >= n0 * a + n1 * b)
        return {box_volume(view), 0.};
      if (n0 * a <= 1e-16 * n1 * b) // plane along the first axis
        {
          const double width = a * (weight + 0.5 * slope * a);
          return {std::min(offset / n1, b) * width, width / n1};
        }

      const double top    = offset - n1 * b; // n0 x where the plane leaves the top
      const double x_full = std::clamp(top / n0, 0., a), x_end = std::min(offset / n0, a);
      const double y_full = top >= 0 ? b : std::min(offset / n1, b);
      const double y_end  = offset < n0 * a ? 0. : std::min((offset - n0 * a) / n1, b);
      const double w_full = weight + slope * x_full, w_end = weight + slope * x_end;
      const double slab  = b * x_full * 0.5 * (weight + w_full);
      const double wedge = (x_end - x_full) * (w_full * (2. * y_full + y_end) + w_end * (y_full + 2. * y_end)) / 6.;
      const double run   = n1 > n0 ? (x_end - x_full) / n1 : (y_full - y_end) / n0;
      return {slab + wedge, 0.5 * (w_full + w_end) * run};
    }

    /// Offset in planar symmetry, closed form (triangle, trapezoid, or complement), for fraction <= 1/2.
    double
    planar_offset(const CornerView &view, const double fraction)
    {
      const double small = std::min(view.n0 * view.a, view.n1 * view.b);
      const double large = std::max(view.n0 * view.a, view.n1 * view.b);
      if (2. * large * fraction < small)
        return std::sqrt(2. * small * large * fraction);
      return large * fraction + 0.5 * small;
    }
  } // namespace

  template <>
  double
  volume_below<2>(const Symmetry symmetry, const Vector<2> &box_lower, const Vector<2> &box_upper,
                  const Vector<2> &origin, const Vector<2> &normal, const double offset)
  {
    const CornerView view = corner_view(symmetry, box_lower, box_upper, normal);
    const double     local =
        offset - normal[0] * (box_lower[0] - origin[0]) - normal[1] * (box_lower[1] - origin[1]) + view.shift;
    return measure(view, local).volume;
  }

  template <>
  double
  offset_of_fraction<2>(const Symmetry symmetry, const Vector<2> &box_lower, const Vector<2> &box_upper,
                        const Vector<2> &normal, const double fraction)
  {
    const CornerView view    = corner_view(symmetry, box_lower, box_upper, normal);
    const double     extent  = view.n0 * view.a + view.n1 * view.b;
    const double     target  = fraction * box_volume(view);
    const double     epsilon = std::numeric_limits<double>::epsilon();
    if (!(fraction > 0))
      return -view.shift;
    if (fraction >= 1)
      return extent - view.shift;

    double low = 0, high = extent;
    double offset = fraction <= 0.5 ? planar_offset(view, fraction) : extent - planar_offset(view, 1. - fraction);
    constexpr int bisections = 200; // Newton needs three to six; bisection alone would need about sixty
    for (int i = 0; i < bisections; ++i)
      {
        const Measure m          = measure(view, offset);
        const double  error      = m.volume - target;
        (error > 0 ? high : low) = offset;
        if (std::abs(error) <= epsilon * target || high - low <= epsilon * extent)
          break;
        const double newton = offset - error / m.derivative;
        const double next   = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (next == offset)
          break;
        const bool settled = std::abs(next - offset) <= epsilon * offset;
        offset             = next;
        if (settled)
          break;
      }
    return offset - view.shift;
  }
} // namespace whipple::interface_plane
