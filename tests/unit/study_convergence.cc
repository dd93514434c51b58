// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/convergence.h>
#include <whipple/study/cost_law.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using convergence::Level;
  using convergence::Verdict;

  constexpr double limit = 0.64, factor = 37.;

  /// f0 + C h^p
  Level
  level(double cell, double order)
  {
    return {cell, limit + factor * std::pow(cell, order)};
  }

  TEST(StudyConvergence, OrderOfErrorsOfAPowerLaw)
  {
    for (const double order : {-0.5, 0.9, 1., 2., 3.3})
      {
        const auto error = [&](double h) { return Level{h, 0.7 * std::pow(h, order)}; };
        EXPECT_NEAR(*convergence::order_of_errors(error(0.03), error(0.02)), order, 1e-12);
      }
    EXPECT_FALSE(convergence::order_of_errors({0.02, 0.}, {0.01, 1e-3}));
    EXPECT_FALSE(convergence::order_of_errors({0.02, 1e-3}, {0.01, 0.}));
  }

  // Ratios of 2, unequal ratios, and orders on both sides of those that error bars trust.
  TEST(StudyConvergence, OrderOfValuesFindsTheManufacturedOrder)
  {
    for (const double order : {0.3, 0.5, 1., 1.4, 2., 3.5})
      for (const auto &[h3, h2, h1] : {std::tuple{0.016, 0.008, 0.004}, {0.03, 0.02, 0.01}, {0.016, 0.012, 0.003}})
        EXPECT_NEAR(*convergence::order_of_values(level(h3, order), level(h2, order), level(h1, order)), order, 1e-6)
            << h3 << ' ' << h2 << ' ' << h1;
    // differences that grow: the sequence moves away
    EXPECT_NEAR(*convergence::order_of_values({4, 1.}, {2, 2.}, {1, 4.}), -1, 1e-6);
    EXPECT_FALSE(convergence::order_of_values({4, 1.}, {2, 2.}, {1, 1.5}));
    EXPECT_FALSE(convergence::order_of_values({4, 1.}, {2, 2.}, {1, 2.}));
  }

  // [Celik2008], table 1, phi = reattachment length: r21 = 1.5, r32 = 1.333, phi = 6.063, 5.972, 5.863 gives
  // p = 1.53, phi_ext = 6.1685, GCI = 2.2 %.
  TEST(StudyConvergence, PublishedExample)
  {
    const std::vector<Level> levels{{1.5 * 1.333, 5.863}, {1.5, 5.972}, {1., 6.063}};
    const auto               estimate = convergence::estimate(levels);
    EXPECT_EQ(estimate.verdict, Verdict::monotone);
    EXPECT_NEAR(*estimate.order, 1.53, 0.01);
    EXPECT_NEAR(*estimate.extrapolated, 6.1685, 0.001);
    EXPECT_NEAR(*estimate.error_bar / 6.063, 0.022, 0.0005);
  }

  TEST(StudyConvergence, MonotoneSequenceIsExtrapolatedToItsLimit)
  {
    for (const double order : {0.5, 1., 2.})
      {
        // the finest three count, in whatever order they come
        const auto estimate =
            convergence::estimate({level(0.004, order), level(0.016, order), {0.5, 99.}, level(0.008, order)});
        EXPECT_EQ(estimate.verdict, Verdict::monotone);
        EXPECT_NEAR(*estimate.extrapolated, limit, 1e-7);
        EXPECT_NEAR(*estimate.error_bar, 1.25 * std::abs(estimate.finest - limit), 1e-7);
      }
  }

  // An order above 2 is an accident: the bar is that of order 2 over the whole range, and larger than the true error.
  TEST(StudyConvergence, ErrorBarTrustsNoOrderAboveTheFormalOne)
  {
    const auto estimate = convergence::estimate({level(0.016, 4), level(0.008, 4), level(0.004, 4)});
    EXPECT_NEAR(*estimate.order, 4., 1e-6);
    EXPECT_NEAR(*estimate.error_bar, 1.25 * (level(0.016, 4).value - level(0.004, 4).value) / 15., 1e-12);
    EXPECT_GT(*estimate.error_bar, std::abs(estimate.finest - limit));
  }

  TEST(StudyConvergence, WhatDoesNotConvergeMonotonouslyIsNamed)
  {
    const auto oscillating = convergence::estimate({{4, 1.}, {2, 2.}, {1, 1.5}});
    EXPECT_EQ(oscillating.verdict, Verdict::oscillating);
    EXPECT_FALSE(oscillating.extrapolated);
    EXPECT_DOUBLE_EQ(*oscillating.error_bar, 1.5);

    const auto diverging = convergence::estimate({{4, 1.}, {2, 1.1}, {1, 1.3}});
    EXPECT_EQ(diverging.verdict, Verdict::diverging);
    EXPECT_FALSE(diverging.extrapolated);
    EXPECT_NEAR(*diverging.error_bar, 0.9, 1e-12);

    // 0.640, 0.640, 0.648: the only change comes last
    EXPECT_EQ(convergence::estimate({{4, 0.64}, {2, 0.64}, {1, 0.648}}).verdict, Verdict::diverging);

    const auto unchanging = convergence::estimate({{4, 1.3}, {2, 1.}, {1, 1.}});
    EXPECT_EQ(unchanging.verdict, Verdict::unchanging);
    EXPECT_NEAR(*unchanging.error_bar, 1.25 * 0.3 / 3., 1e-12);
  }

  TEST(StudyConvergence, FewLevels)
  {
    const auto two = convergence::estimate({{2, 1.1}, {1, 1.}});
    EXPECT_EQ(two.verdict, Verdict::two_levels);
    EXPECT_NEAR(*two.error_bar, 0.3, 1e-12);
    const auto one = convergence::estimate({{1, 1.}});
    EXPECT_EQ(one.verdict, Verdict::one_level);
    EXPECT_FALSE(one.error_bar);
    EXPECT_THROW(convergence::estimate({}), Error);
  }

  TEST(StudyConvergence, PowerLawThroughPoints)
  {
    const auto law = convergence::fit_power_law({{0.1, 3e-2}, {0.05, 1.5e-2}, {0.025, 0.75e-2}});
    EXPECT_NEAR(law.exponent, 1., 1e-12);
    EXPECT_NEAR(law(0.01), 3e-3, 1e-12);
    EXPECT_THROW(convergence::fit_power_law({{0.1, 1.}}), Error);
    EXPECT_THROW(convergence::fit_power_law({{0.1, 1.}, {0.05, 0.}}), Error);
  }

  /// Cell steps h^-3, 2 microseconds each, after a start of half a second.
  CostSample
  sample(double cell)
  {
    const double cell_steps = std::pow(cell, -3.);
    return {cell, cell_steps, 0.5 + 2e-6 * cell_steps};
  }

  TEST(StudyCost, LawIsFoundBehindTheStart)
  {
    const CostLaw law = fit_cost({sample(0.02), sample(0.04), sample(0.01)});
    EXPECT_NEAR(law.cell_steps.exponent, -3., 1e-9);
    EXPECT_NEAR(law.start_s, 0.5, 1e-9);
    EXPECT_NEAR(law.seconds(0.0025), sample(0.0025).wall_s, 1e-3);
    // from one run: all of its time grows
    EXPECT_NEAR(fit_cost({sample(0.01)}).seconds(0.005), 8. * sample(0.01).wall_s, 1e-9);
    EXPECT_THROW(fit_cost({}), Error);
  }

  TEST(StudyCost, ForecastTakesTheSeriesItselfOrElseTheOthers)
  {
    CostForecast forecast;
    EXPECT_FALSE(forecast.seconds("a", 0.01));
    forecast.add("a", {0.01, 1e6, 3.});
    forecast.add("b", {0.01, 1e6, 5.});
    EXPECT_NEAR(*forecast.seconds("a", 0.01), 3., 1e-9);
    EXPECT_NEAR(*forecast.seconds("c", 0.01), 4., 1e-9);
  }
} // namespace
