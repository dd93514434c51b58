// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/cell_geometry.h>
#include <whipple/scene/body_volume.h>
#include <whipple/scene/plate_shape.h>
#include <whipple/scene/sphere_shape.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace
{
  using namespace whipple;
  using std::numbers::pi;

  /// Adaptive Simpson quadrature to an absolute tolerance.
  double
  integrate(const std::function<double(double)> &f, double a, double b, double tolerance, int depth = 40)
  {
    const double m = 0.5 * (a + b), fa = f(a), fm = f(m), fb = f(b);
    const double whole = (b - a) / 6. * (fa + 4. * fm + fb);
    const double left  = (m - a) / 6. * (fa + 4. * f(0.5 * (a + m)) + fm);
    const double right = (b - m) / 6. * (fm + 4. * f(0.5 * (m + b)) + fb);
    if (depth == 0 || (depth < 34 && std::abs(left + right - whole) < 15. * tolerance))
      return left + right;
    return integrate(f, a, m, 0.5 * tolerance, depth - 1) + integrate(f, m, b, 0.5 * tolerance, depth - 1);
  }

  /// Volume of a ball or disk in a box by quadrature over axis 1 of the length (or ring area) of each line.
  double
  reference(Symmetry symmetry, const Sphere<2> &sphere, const Vector<2> &lower, const Vector<2> &upper)
  {
    const auto line = [&](double z) {
      const double t = z - sphere.center[1], square = 0.25 * sphere.diameter * sphere.diameter - t * t;
      if (square <= 0)
        return 0.;
      const double s = std::sqrt(square);
      const double p = std::max(lower[0], sphere.center[0] - s), q = std::min(upper[0], sphere.center[0] + s);
      if (p >= q)
        return 0.;
      return symmetry == Symmetry::planar ? q - p : pi * (q * q - std::max(p, 0.) * std::max(p, 0.));
    };
    return integrate(line, lower[1], upper[1], 1e-13);
  }

  double
  cell_sum(Symmetry symmetry, const Shape<2> &shape, const Vector<2> &origin, double h, int nx, int ny)
  {
    long double sum = 0; // thousands of equal summands: their rounding errors would add up
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
        sum += body_volume<2>(symmetry, shape, {origin[0] + i * h, origin[1] + j * h},
                              {origin[0] + (i + 1) * h, origin[1] + (j + 1) * h});
    return static_cast<double>(sum);
  }

  TEST(SceneBodyVolume, RandomBoxesAgreeWithQuadrature)
  {
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> place(-1, 1), size(0.01, 0.6);
    for (int i = 0; i < 300; ++i)
      {
        const Vector<2> corner{place(random), place(random)};
        const Vector<2> upper{corner[0] + size(random), corner[1] + size(random)};
        const Sphere<2> disk{{0.3 * place(random), 0.3 * place(random)}, 1. + 0.5 * place(random)};
        EXPECT_NEAR(body_volume<2>(Symmetry::planar, disk, corner, upper),
                    reference(Symmetry::planar, disk, corner, upper), 1e-11);

        const Vector<2> inner{std::abs(corner[0]), corner[1]};
        const Vector<2> outer{inner[0] + size(random), upper[1]};
        const Sphere<2> ball{{0, disk.center[1]}, disk.diameter};
        EXPECT_NEAR(body_volume<2>(Symmetry::axisymmetric, ball, inner, outer),
                    reference(Symmetry::axisymmetric, ball, inner, outer), 1e-11);
      }
  }

  TEST(SceneBodyVolume, CellsSumToTheBody)
  {
    const Sphere<2> sphere{{0, -0.16}, 0.32};
    for (const double h : {0.004, 0.0037, 0.016, 0.2})
      {
        const int n = static_cast<int>(0.4 / h) + 2;
        EXPECT_NEAR(cell_sum(Symmetry::axisymmetric, sphere, {0, -0.4}, h, n, 2 * n) / (pi * 0.32 * 0.32 * 0.32 / 6.),
                    1., 1e-13);
        EXPECT_NEAR(cell_sum(Symmetry::planar, sphere, {-0.4, -0.4}, h, 2 * n, 2 * n) / (pi * 0.16 * 0.16), 1., 1e-13);
        EXPECT_NEAR(cell_sum(Symmetry::planar, sphere, {0, -0.4}, h, n, 2 * n) / (0.5 * pi * 0.16 * 0.16), 1., 1e-13);
      }
    const Plate<2> disk{-0.0131, 0.081, 0.23};
    EXPECT_NEAR(cell_sum(Symmetry::axisymmetric, disk, {0, -0.1}, 0.004, 70, 70) / (pi * 0.23 * 0.23 * 0.081), 1.,
                1e-13);
    EXPECT_NEAR(cell_sum(Symmetry::planar, disk, {-0.28, -0.1}, 0.004, 140, 70) / (2 * 0.23 * 0.081), 1., 1e-13);
    const Plate<2> plate{0.013, 0.081};
    EXPECT_NEAR(cell_sum(Symmetry::axisymmetric, plate, {0, 0}, 0.01, 40, 40) / (pi * 0.4 * 0.4 * 0.081), 1., 1e-13);
    const Box<2> ring{{0.1003, -0.07}, {0.2111, 0.0717}};
    EXPECT_NEAR(cell_sum(Symmetry::axisymmetric, ring, {0, -0.1}, 0.004, 60, 60) /
                    (pi * (0.2111 * 0.2111 - 0.1003 * 0.1003) * 0.1417),
                1., 1e-13);
  }

  // Painted cells must be exactly full inside a body: no traces of open void.
  TEST(SceneBodyVolume, CellsInsideAreFullToTheBit)
  {
    const Vector<2>        lower{0.0123, -0.1877}, upper{0.0163, -0.1837};
    const CornerVectors<2> quad = CellShape<2>::box(lower, upper);
    for (const Shape<2> &shape :
         {Shape<2>(Sphere<2>{{0, -0.16}, 0.32}), Shape<2>(Plate<2>{-0.2, 0.081}), Shape<2>(Box<2>{{0, -1}, {1, 1}})})
      {
        for (const Symmetry symmetry : {Symmetry::axisymmetric, Symmetry::planar})
          EXPECT_EQ(body_volume<2>(symmetry, shape, lower, upper), cell_volume<2>(symmetry, quad));
      }
  }

  TEST(SceneBodyVolume, OutsideAndTouchingAreZero)
  {
    const Shape<2> sphere = Sphere<2>{{0, 0}, 2};
    EXPECT_EQ(body_volume<2>(Symmetry::axisymmetric, sphere, {0, 1}, {0.5, 1.5}), 0.);
    EXPECT_EQ(body_volume<2>(Symmetry::axisymmetric, sphere, {0.8, 0.8}, {1, 1}), 0.);
    EXPECT_EQ(body_volume<2>(Symmetry::planar, sphere, {1, -0.1}, {1.5, 0.1}), 0.);
    EXPECT_EQ(body_volume<2>(Symmetry::planar, Plate<2>{0, 1}, {0, 1}, {1, 2}), 0.);
  }

  TEST(SceneShape, OverlapIsNotTouching)
  {
    const Shape<2> sphere = Sphere<2>{{0, -0.16}, 0.32}, plate = Plate<2>{0, 0.081};
    EXPECT_FALSE(overlap<2>(sphere, plate));
    EXPECT_FALSE(overlap<2>(plate, Plate<2>{0.081, 0.1}));
    EXPECT_TRUE(overlap<2>(plate, Plate<2>{0.08, 0.1}));
    EXPECT_TRUE(overlap<2>(plate, Plate<2>{0, 0.081}));
    EXPECT_TRUE(overlap<2>(sphere, Sphere<2>{{0, 0.1}, 0.3}));
    EXPECT_TRUE(overlap<2>(sphere, Plate<2>{-0.001, 0.1}));
    EXPECT_TRUE(overlap<2>(Plate<2>{-0.001, 0.1}, sphere));
    // the corner of the box is outside the sphere though their bounding boxes share volume
    EXPECT_FALSE(overlap<2>(sphere, Box<2>{{0.15, -0.04}, {0.3, 0.1}}));
    EXPECT_TRUE(overlap<2>(sphere, Box<2>{{-1, -1}, {1, 1}}));
    EXPECT_FALSE(overlap<2>(Box<2>{{0, 0}, {1, 1}}, Box<2>{{1, 0}, {2, 1}}));
  }
} // namespace
