// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/closure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
  using namespace whipple;

  std::vector<double>
  share(double volume, double next, const std::vector<closure::Part> &part)
  {
    std::vector<double> result(part.size());
    closure::share_volume(volume, next, part, result);
    return result;
  }

  TEST(HydroClosure, OpenVoidGivesFirst)
  {
    EXPECT_EQ(share(1., 0.8, {{0.7, 1., 0.}})[0], 0.7);
    EXPECT_DOUBLE_EQ(share(1., 0.6, {{0.7, 1., 0.}})[0], 0.6);
    EXPECT_EQ(share(1., 0.8, {{0.4, 1., 0.1}})[0], 0.4); // a little material, whatever its pressure
  }

  TEST(HydroClosure, MaterialUnderPressureThatNearlyFillsTheCellIsCompressedWithIt)
  {
    // w = f S(20 f - 19): S(0) = 0, S(0.5) = 0.5, S(0.98) = 1 - 1.184e-3
    EXPECT_EQ(share(1., 0.8, {{0.7, 1., 0.1}})[0], 0.7);
    EXPECT_DOUBLE_EQ(share(1., 0.98, {{0.975, 1., 0.1}})[0], 0.975 - 0.975 * 0.5 * 0.02);
    EXPECT_NEAR(share(1., 0.9999, {{0.999, 1., 0.1}})[0] / 0.999, 1. - 0.998816e-4, 1e-12);
    // and the cell is never overfull
    EXPECT_DOUBLE_EQ(share(1., 0.6, {{0.7, 1., 0.1}})[0], 0.6);
  }

  TEST(HydroClosure, ExpansionOpensVoidUnlessThereIsPressure)
  {
    const auto v = share(1., 1.1, {{0.3, 1., 0.1}, {0.4, 1., -0.1}});
    EXPECT_DOUBLE_EQ(v[0], 0.33);
    EXPECT_EQ(v[1], 0.4);
  }

  TEST(HydroClosure, FullCellSharesByCompressibility)
  {
    const double next = 1. - 1e-6;
    const auto   v    = share(1., next, {{0.25, 2., 0.}, {0.75, 0.5, 0.}});
    EXPECT_DOUBLE_EQ(v[0] + v[1], next);
    // the same pressure change: K_m dV_m / V_m equal
    EXPECT_NEAR((v[0] / 0.25 - 1.) * 2., (v[1] / 0.75 - 1.) * 0.5, 1e-11);
  }

  TEST(HydroClosure, GasThatIsSqueezedFarBeyondItsModulusStiffens)
  {
    // the solid has to take most of the compression: x = K_s ln(V_s / V_s') is that of the gas, V_g / (e x / K_g)
    constexpr double solid = 0.999, gas = 0.001, stiff = 1., soft = 2.5e-6;
    const auto       v = share(1., 0.997, {{solid, stiff, 0.}, {gas, soft, 0.}});
    EXPECT_DOUBLE_EQ(v[0] + v[1], 0.997);
    const double x = stiff * std::log(solid / v[0]);
    EXPECT_NEAR(x, 2.0e-3, 1e-5);
    EXPECT_NEAR(v[1] / (gas * soft / (std::exp(1.) * x)), 1., 1e-9);
    EXPECT_GT(v[1], 1e-4 * gas);
    // around y = 1 the volume and its slope go through
    const double below = share(2., 1. + std::exp(-0.999), {{1., 1e9, 0.}, {1., 1., 0.}})[1];
    const double above = share(2., 1. + 1. / (std::exp(1.) * 1.001), {{1., 1e9, 0.}, {1., 1., 0.}})[1];
    EXPECT_NEAR(below, std::exp(-0.999), 1e-8);
    EXPECT_NEAR(above, 1. / (std::exp(1.) * 1.001), 1e-8);
    EXPECT_NEAR((below - above) / 0.002, std::exp(-1.), 1e-3);
  }

  TEST(HydroClosure, NothingBecomesNegative)
  {
    const auto v   = share(1., 0.05, {{0.9, 1e3, 0.}, {1e-7, 1e-6, 0.}, {0.1 - 1e-7, 1e-3, 0.}});
    double     sum = 0;
    for (const double volume : v)
      {
        EXPECT_GE(volume, 0.);
        sum += volume;
      }
    EXPECT_NEAR(sum, 0.05, 1e-16);
    EXPECT_DOUBLE_EQ(share(1., 0.5, {{0.25, 0., 0.}, {0.75, 1., 0.}})[0], 0.125);
  }

  TEST(HydroClosure, SolidBesideOpenVoidStretchesUntilItsSurfaceIsFree)
  {
    // half filled, P = -0.001: expands with the cell while that is above the least principal deviator
    double                  volume[1];
    const closure::Part     held[]{{0.5, 0.8, -0.001, -0.002}}, loose[]{{0.5, 0.8, -0.001, -0.0005}};
    const std::span<double> result(volume);
    closure::share_volume(1., 1.1, held, result);
    EXPECT_DOUBLE_EQ(volume[0], 0.55);
    closure::share_volume(1., 1.1, loose, result);
    EXPECT_DOUBLE_EQ(volume[0], 0.5);
  }
} // namespace
