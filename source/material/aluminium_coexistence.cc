// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/aluminium_coexistence.h>

#include <vector>

namespace whipple::aluminium_phases
{
  namespace
  {
    /// Value at the next of equidistant nodes, by the parabola through the last three.
    double
    extrapolate(const std::vector<double> &values)
    {
      const std::size_t n = values.size();
      return n < 3 ? values.back() : 3. * (values[n - 1] - values[n - 2]) + values[n - 3];
    }

    struct MeltingPoint
    {
      double temperature, solid, liquid;
    };

    /// Zero pressure, by Newton's method with Clapeyron's slope.
    MeltingPoint
    melting_point()
    {
      MeltingPoint point{956., 2.57, 2.38};
      for (int iteration = 0; iteration < 20; ++iteration)
        {
          equilibrate<Solid, Fluid>(point.temperature, point.solid, point.liquid);
          const double volume = 1. / point.liquid - 1. / point.solid;
          const double heat =
              Fluid::entropy(point.liquid, point.temperature) - Solid::entropy(point.solid, point.temperature);
          point.temperature -= Solid::thermal(point.solid, point.temperature).pressure * volume / heat;
        }
      return point;
    }

    /// Least dP/dgamma of an isotherm, and where: search by thirds about the least of a coarse scan.
    std::pair<double, double>
    softest(double temperature)
    {
      const auto stiffness = [&](double true_density) { return Fluid::thermal(true_density, temperature).dp_ddensity; };
      double     best      = 0.1;
      for (double true_density = 0.1; true_density < 1.8; true_density += 0.01)
        if (stiffness(true_density) < stiffness(best))
          best = true_density;
      double lower = best - 0.01, upper = best + 0.01;
      while (upper - lower > 1e-9)
        {
          const double a = lower + (upper - lower) / 3., b = upper - (upper - lower) / 3.;
          (stiffness(a) < stiffness(b) ? upper : lower) = stiffness(a) < stiffness(b) ? b : a;
        }
      return {0.5 * (lower + upper), stiffness(0.5 * (lower + upper))};
    }
  } // namespace

  Melting
  melting_curve()
  {
    constexpr int       steps = 2000;
    const MeltingPoint  start = melting_point();
    const double        step  = (18000. - start.temperature) / steps;
    std::vector<double> solid{start.solid}, liquid{start.liquid};
    for (int i = 1; i <= steps; ++i)
      {
        double dense = extrapolate(solid), light = extrapolate(liquid);
        equilibrate<Solid, Fluid>(start.temperature + i * step, dense, light);
        solid.push_back(dense);
        liquid.push_back(light);
      }
    return {Melting::Parameter::temperature, 0., HermiteTable(start.temperature, step, solid),
            HermiteTable(start.temperature, step, liquid)};
  }

  CriticalPoint
  critical_point()
  {
    double lower = 2000., upper = 20000.;
    while (upper - lower > 1e-9)
      {
        const double middle                           = 0.5 * (lower + upper);
        (softest(middle).second < 0. ? lower : upper) = middle;
      }
    return {lower, softest(lower).first};
  }

  Boiling
  boiling_curve()
  {
    constexpr int       steps    = 500;
    constexpr double    coldest  = 1250.;
    const CriticalPoint critical = critical_point();
    const double        span     = std::sqrt(1. - coldest / critical.temperature);

    // The vapour is ideal at the cold end: its density follows from the Gibbs energy of the liquid.
    double dense = 2.3, light = 1e-9;
    light *= std::exp((Fluid::gibbs(dense, coldest) - Fluid::gibbs(light, coldest)) / (gas_constant * coldest));
    std::vector<double> liquid, vapour; // from the cold end to the critical point
    for (int i = steps; i > 0; --i)
      {
        const double distance = span * i / steps;
        if (!liquid.empty())
          {
            dense = extrapolate(liquid);
            light = std::exp(extrapolate(vapour));
          }
        equilibrate<Fluid, Fluid>(critical.temperature * (1. - distance * distance), dense, light);
        liquid.push_back(dense);
        vapour.push_back(std::log(light));
      }
    liquid.push_back(critical.density);
    vapour.push_back(std::log(critical.density));
    std::reverse(liquid.begin(), liquid.end());
    std::reverse(vapour.begin(), vapour.end());
    return {Boiling::Parameter::critical_distance, critical.temperature, HermiteTable(0., span / steps, liquid),
            HermiteTable(0., span / steps, vapour)};
  }
} // namespace whipple::aluminium_phases
