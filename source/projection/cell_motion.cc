// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/cell_motion.h>

#include <cmath>

namespace whipple::projection
{
  void
  Motion::add(const Motion &other)
  {
    if (other.mass == 0)
      return;
    const double total = mass + other.mass, reduced = mass * (other.mass / total);
    Vector<2>    dx, du;
    for (int a = 0; a < 2; ++a)
      {
        dx[a] = other.mean_x[a] - mean_x[a];
        du[a] = other.mean_u[a] - mean_u[a];
      }
    kinetic += other.kinetic;
    for (int a = 0; a < 2; ++a)
      {
        kinetic += 0.5 * reduced * du[a] * du[a];
        for (int b = 0; b < 2; ++b)
          {
            xx[a][b] += other.xx[a][b] + reduced * dx[a] * dx[b];
            ux[a][b] += other.ux[a][b] + reduced * du[a] * dx[b];
          }
        mean_x[a] += other.mass / total * dx[a];
        mean_u[a] += other.mass / total * du[a];
      }
    mass = total;
  }

  std::array<Vector<2>, 2>
  Motion::gradient(double size) const
  {
    // principal axes of the symmetric tensor xx
    const double    mean = 0.5 * (xx[0][0] + xx[1][1]), half = 0.5 * (xx[0][0] - xx[1][1]);
    const double    radius = std::hypot(half, xx[0][1]);
    const double    angle  = 0.5 * std::atan2(xx[0][1], half);
    const Vector<2> major{{std::cos(angle), std::sin(angle)}}, minor{{-major[1], major[0]}};

    std::array<Vector<2>, 2> result{};
    const auto               along = [&](const Vector<2> &axis, double spread) {
      constexpr double least = 1e-3;
      if (!(spread > least * mass * size * size))
        return;
      for (int a = 0; a < 2; ++a)
        {
          const double slope = (ux[a][0] * axis[0] + ux[a][1] * axis[1]) / spread;
          for (int b = 0; b < 2; ++b)
            result[a][b] += slope * axis[b];
        }
    };
    along(major, mean + radius);
    along(minor, mean - radius);
    return result;
  }
} // namespace whipple::projection
