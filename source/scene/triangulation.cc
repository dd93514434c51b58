// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/triangulation.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  double
  turn_area(const Vector<2> &a, const Vector<2> &b, const Vector<2> &c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  double
  outline_area(const std::vector<Vector<2>> &corners)
  {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      twice += turn_area(corners[0], corners[i], corners[i + 1]);
    return 0.5 * twice;
  }

  namespace
  {
    using Corners = std::vector<Vector<2>>;

    /// Sine of the angle at corner i, positive where the outline turns left.
    double
    bend(const Corners &corners, std::size_t i)
    {
      const std::size_t n = corners.size();
      const Vector<2>  &a = corners[(i + n - 1) % n], &b = corners[i], &c = corners[(i + 1) % n];
      return turn_area(a, b, c) / (std::hypot(b[0] - a[0], b[1] - a[1]) * std::hypot(c[0] - b[0], c[1] - b[1]));
    }

    /// Whether the triangle at corner i lies inside the outline: it turns left there and no other corner is in it.
    bool
    is_ear(const Corners &corners, std::size_t i)
    {
      const std::size_t n = corners.size(), before = (i + n - 1) % n, after = (i + 1) % n;
      const Vector<2>  &a = corners[before], &b = corners[i], &c = corners[after];
      if (!(turn_area(a, b, c) > 0))
        return false;
      for (std::size_t k = 0; k < n; ++k)
        if (k != before && k != i && k != after && turn_area(a, b, corners[k]) >= 0 &&
            turn_area(b, c, corners[k]) >= 0 && turn_area(c, a, corners[k]) >= 0)
          return false;
      return true;
    }

    /// Of the ears the roundest, so that few slivers come about; where round-off hides all, the corner that turns most.
    std::size_t
    next_ear(const Corners &corners)
    {
      std::size_t best = corners.size(), left = 0;
      for (std::size_t i = 0; i < corners.size(); ++i)
        {
          if (bend(corners, i) > bend(corners, left))
            left = i;
          if ((best == corners.size() || bend(corners, i) > bend(corners, best)) && is_ear(corners, i))
            best = i;
        }
      return best < corners.size() ? best : left;
    }
  } // namespace

  std::vector<std::array<Vector<2>, 3>>
  triangulate(std::vector<Vector<2>> corners)
  {
    constexpr double                      straight = 1e-14; // a corner on the line of its neighbours encloses nothing
    std::vector<std::array<Vector<2>, 3>> triangles;
    while (corners.size() > 2)
      {
        const std::size_t n = corners.size();
        std::size_t       i = 0;
        while (i < n && std::abs(bend(corners, i)) > straight)
          ++i;
        if (i == n)
          {
            i = next_ear(corners);
            triangles.push_back({corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]});
          }
        corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
      }
    return triangles;
  }
} // namespace whipple
