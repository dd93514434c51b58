// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/study/convergence.h>

#include <algorithm>
#include <cmath>

namespace whipple::convergence
{
  namespace
  {
    /// Bounds of the orders that are looked for; a sequence outside counts as this fast or slow.
    constexpr double smallest_order = -10, largest_order = 20;

    /// (r32^p - 1) / (1 - r21^-p), increasing in p; its limit at p = 0.
    double
    ratio_of_differences(double p, double log_r21, double log_r32)
    {
      if (std::abs(p) < 1e-9)
        return log_r32 / log_r21;
      return std::expm1(p * log_r32) / -std::expm1(-p * log_r21);
    }

    /// Values that differ by less than this part of them are equal: conserved sums, for one.
    constexpr double round_off = 1e-11;

    double
    trusted(double order)
    {
      return std::clamp(order, least_order, formal_order);
    }

    /// Part of the difference between two levels that is left at the finer one if the error goes with h^order.
    double
    remainder(double ratio, double order)
    {
      return 1. / std::expm1(order * std::log(ratio));
    }

    Estimate
    estimate_of_three(const Level &coarse, const Level &medium, const Level &fine)
    {
      const double e32 = coarse.value - medium.value, e21 = medium.value - fine.value, e31 = coarse.value - fine.value;
      const double r21 = medium.cell / fine.cell, r31 = coarse.cell / fine.cell;
      const auto [low, high] = std::minmax({coarse.value, medium.value, fine.value});
      const double least_bar = safety * std::abs(e31) * remainder(r31, formal_order);

      Estimate result;
      result.finest = fine.value;
      if (std::abs(e21) <= round_off * std::max(std::abs(low), std::abs(high)))
        {
          // most likely a value that can only take steps: it has not moved yet
          result.verdict      = Verdict::unchanging;
          result.extrapolated = fine.value;
          result.error_bar    = safety * std::abs(e31) * remainder(r31, 1.);
          return result;
        }
      result.order = order_of_values(coarse, medium, fine);
      if (e32 * e21 < 0)
        {
          result.verdict   = Verdict::oscillating;
          result.error_bar = cautious_safety * (high - low) / 2;
        }
      else if (!result.order || *result.order <= 0)
        {
          result.verdict   = Verdict::diverging;
          result.error_bar = cautious_safety * (high - low);
        }
      else
        {
          const double left   = e21 * remainder(r21, trusted(*result.order));
          result.verdict      = Verdict::monotone;
          result.extrapolated = fine.value - left;
          result.error_bar    = std::max(safety * std::abs(left), least_bar);
        }
      return result;
    }
  } // namespace

  std::string
  name(Verdict verdict)
  {
    switch (verdict)
      {
      case Verdict::one_level:
        return "one level";
      case Verdict::two_levels:
        return "two levels";
      case Verdict::monotone:
        return "monotone";
      case Verdict::unchanging:
        return "unchanging";
      case Verdict::oscillating:
        return "oscillating";
      case Verdict::diverging:
        return "diverging";
      }
    throw Error("no such verdict");
  }

  double
  Estimate::limit_uncertainty() const
  {
    return std::max(0., error_bar.value_or(0.) - std::abs(finest - limit()));
  }

  std::optional<double>
  order_of_errors(const Level &coarse, const Level &fine)
  {
    if (!(coarse.value > 0 && fine.value > 0))
      return std::nullopt;
    return std::log(coarse.value / fine.value) / std::log(coarse.cell / fine.cell);
  }

  std::optional<double>
  order_of_values(const Level &coarse, const Level &medium, const Level &fine)
  {
    const double ratio = (coarse.value - medium.value) / (medium.value - fine.value);
    if (!(ratio > 0) || !std::isfinite(ratio))
      return std::nullopt;
    const double log_r21 = std::log(medium.cell / fine.cell), log_r32 = std::log(coarse.cell / medium.cell);
    double       low = smallest_order, high = largest_order;
    while (high - low > 1e-10)
      {
        const double middle                                                   = 0.5 * (low + high);
        (ratio_of_differences(middle, log_r21, log_r32) < ratio ? low : high) = middle;
      }
    return 0.5 * (low + high);
  }

  Estimate
  estimate(std::vector<Level> levels)
  {
    if (levels.empty())
      throw Error("no level to estimate an error from");
    std::sort(levels.begin(), levels.end(), [](const Level &a, const Level &b) { return a.cell < b.cell; });
    if (levels.size() >= 3)
      return estimate_of_three(levels[2], levels[1], levels[0]);
    Estimate result;
    result.finest = levels[0].value;
    if (levels.size() == 2)
      {
        result.verdict   = Verdict::two_levels;
        result.error_bar = cautious_safety * std::abs(levels[1].value - levels[0].value) *
                           remainder(levels[1].cell / levels[0].cell, 1.);
      }
    return result;
  }

  double
  PowerLaw::operator()(double cell) const
  {
    return factor * std::pow(cell, exponent);
  }

  PowerLaw
  fit_power_law(const std::vector<Level> &levels)
  {
    if (levels.size() < 2)
      throw Error("a power law needs two levels, not " + std::to_string(levels.size()));
    double mean_x = 0, mean_y = 0;
    for (const Level &level : levels)
      {
        if (!(level.value > 0 && level.cell > 0))
          throw Error("a power law needs values > 0, not " + std::to_string(level.value) + " at cells of " +
                      std::to_string(level.cell) + " cm");
        mean_x += std::log(level.cell) / levels.size();
        mean_y += std::log(level.value) / levels.size();
      }
    double xx = 0, xy = 0;
    for (const Level &level : levels)
      {
        const double x = std::log(level.cell) - mean_x;
        xx += x * x;
        xy += x * (std::log(level.value) - mean_y);
      }
    const double exponent = xy / xx;
    return {std::exp(mean_y - exponent * mean_x), exponent};
  }
} // namespace whipple::convergence
