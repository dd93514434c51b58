// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/guderley_passage.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace whipple::exact
{
  namespace
  {
    using Series        = SonicPassage::Series;
    constexpr int order = SonicPassage::order;

    Series
    linear(double constant, double slope)
    {
      return {constant, slope};
    }

    Series
    combine(double a, const Series &p, double b, const Series &q)
    {
      Series result;
      for (int i = 0; i <= order; ++i)
        result[i] = a * p[i] + b * q[i];
      return result;
    }

    Series
    operator*(const Series &p, const Series &q)
    {
      Series result{};
      for (int i = 0; i <= order; ++i)
        for (int j = 0; i + j <= order; ++j)
          result[i + j] += p[i] * q[j];
      return result;
    }

    Series
    derivative(const Series &p)
    {
      Series result{};
      for (int i = 1; i <= order; ++i)
        result[i - 1] = i * p[i];
      return result;
    }

    /// Integral from 0 of p / q; q[0] may not vanish.
    Series
    integral_of_ratio(const Series &p, const Series &q)
    {
      Series ratio{}, result{};
      for (int i = 0; i < order; ++i)
        {
          double rest = p[i];
          for (int j = 0; j < i; ++j)
            rest -= ratio[j] * q[i - j];
          ratio[i]      = rest / q[0];
          result[i + 1] = ratio[i] / (i + 1);
        }
      return result;
    }

    double
    evaluate(const Series &p, double x)
    {
      double result = 0;
      for (int i = order; i >= 0; --i)
        result = result * x + p[i];
      return result;
    }

    /// The equations about a point in powers of U - U of the point.
    struct Expansion
    {
      Series d, n, u, u_minus_1;
      Series residual; ///< of dZ/dU = Z (ln Z)' / U', times D-free factors
    };

    Expansion
    expand(const SelfSimilarFlow &flow, double point, const Series &z)
    {
      Expansion e;
      e.u                   = linear(point, 1.);
      e.u_minus_1           = linear(point - 1., 1.);
      const Series to_slope = linear(point - 1. / flow.alpha, 1.);
      e.d                   = combine(1., e.u_minus_1 * e.u_minus_1, -1., z);
      e.n                   = combine(-1., e.u * e.u_minus_1 * to_slope, 1.,
                                      z * linear(flow.dimensions * point - flow.sigma(), flow.dimensions));
      const Series spread   = combine(1., e.n, flow.dimensions, e.u * e.d);
      const Series rise     = z * combine(-(flow.exponent - 1.), spread, -2., to_slope * e.d);
      e.residual            = combine(1., rise, -1., derivative(z) * e.n * e.u_minus_1);
      return e;
    }

    /// Roots of a x^2 + b x + c, the larger first; none if they are not real.
    std::optional<std::array<double, 2>>
    roots(double a, double b, double c)
    {
      const double discriminant = b * b - 4. * a * c;
      if (!(discriminant >= 0))
        return std::nullopt;
      const double half = std::sqrt(discriminant) / (2. * a), middle = -b / (2. * a);
      return std::array<double, 2>{middle + std::abs(half), middle - std::abs(half)};
    }

    struct Rates
    {
      double y, z, g; ///< dy/dU, dZ/dU, d(ln G)/dU
    };

    Rates
    rates(const SelfSimilarFlow &flow, double u, double z)
    {
      const double lambda = 1. / flow.alpha, w = u - 1.;
      const double d = w * w - z, n = -u * w * (u - lambda) + z * (flow.dimensions * u - flow.sigma());
      const double spread = 1. + flow.dimensions * u * d / n;
      return {d / n, -z * ((flow.exponent - 1.) * spread + 2. * (u - lambda) * d / n) / w, -spread / w};
    }
  } // namespace

  std::optional<SonicPassage>
  SonicPassage::through(const SelfSimilarFlow &flow, bool larger)
  {
    // N = 0 with Z = (U - 1)^2, divided by U - 1
    const double n = flow.dimensions, sigma = flow.sigma();
    const auto   points = roots(n - 1., 1. / flow.alpha - n - sigma, sigma);
    if (!points)
      return std::nullopt;
    SonicPassage passage;
    passage.point       = (*points)[larger ? 0 : 1];
    Series &z           = passage.sound_square;
    z[0]                = (passage.point - 1.) * (passage.point - 1.);
    const auto residual = [&](int coefficient, double value) {
      z[coefficient] = value;
      return expand(flow, passage.point, z).residual[coefficient];
    };
    // quadratic in the slope, linear in every later coefficient
    const double at0 = residual(1, 0.), sum = residual(1, 1.) + residual(1, -1.);
    const double square = 0.5 * sum - at0;
    const auto   slopes = roots(square, residual(1, 1.) - at0 - square, at0);
    if (!slopes)
      return std::nullopt;
    z[1] = (*slopes)[0];
    for (int i = 2; i < order; ++i)
      {
        const double zero = residual(i, 0.), one = residual(i, 1.);
        z[i] = zero / (zero - one);
      }
    Expansion e = expand(flow, passage.point, z);
    // D and N vanish at the point: their ratio is that of the next coefficients
    Series d{}, nn{};
    std::copy(e.d.begin() + 1, e.d.end(), d.begin());
    std::copy(e.n.begin() + 1, e.n.end(), nn.begin());
    passage.y           = integral_of_ratio(d, nn);
    const Series spread = combine(1., nn, n, e.u * d);
    passage.log_density = integral_of_ratio(combine(-1., spread, 0., spread), nn * e.u_minus_1);
    return passage;
  }

  SelfSimilarState
  SonicPassage::at(double velocity) const
  {
    const double x = velocity - point;
    return {evaluate(y, x), velocity, evaluate(sound_square, x), evaluate(log_density, x)};
  }

  std::vector<SelfSimilarState>
  follow_velocity(const SelfSimilarFlow &flow, const SelfSimilarState &from, double to, int steps)
  {
    std::vector<SelfSimilarState> result = {from};
    const double                  h      = (to - from.velocity) / steps;
    for (int i = 0; i < steps; ++i)
      {
        const SelfSimilarState &s = result.back();
        const double            u = s.velocity, z = s.sound_square;
        const Rates             a = rates(flow, u, z), b = rates(flow, u + h / 2, z + h / 2 * a.z),
                    c = rates(flow, u + h / 2, z + h / 2 * b.z), d = rates(flow, u + h, z + h * c.z);
        const auto change = [&](double Rates::*rate) {
          return h / 6. * (a.*rate + 2. * (b.*rate) + 2. * (c.*rate) + d.*rate);
        };
        result.push_back({s.y + change(&Rates::y), from.velocity + h * (i + 1), z + change(&Rates::z),
                          s.log_density + change(&Rates::g)});
      }
    return result;
  }

  SelfSimilarState
  behind_strong_shock(const SelfSimilarFlow &flow)
  {
    const double k = flow.exponent, over = k + 1.;
    return {0., 2. / over, 2. * k * (k - 1.) / (over * over), std::log(over / (k - 1.))};
  }

  namespace
  {
    /// Z of the analytic solution where U is that behind the shock, less Z there; none if it cannot be had.
    std::optional<double>
    miss(const SelfSimilarFlow &flow, bool larger)
    {
      const auto passage = SonicPassage::through(flow, larger);
      if (!passage)
        return std::nullopt;
      const SelfSimilarState shock = behind_strong_shock(flow);
      const double           start = passage->velocity() + 0.02 * (shock.velocity - passage->velocity());
      const double           value =
          follow_velocity(flow, passage->at(start), shock.velocity, 500).back().sound_square - shock.sound_square;
      return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
    }

    std::optional<double>
    find_alpha(SelfSimilarFlow flow, bool larger)
    {
      const auto miss_of = [&](double alpha) {
        flow.alpha = alpha;
        return miss(flow, larger);
      };
      std::optional<double> last;
      constexpr double      step = 5e-4;
      for (double alpha = 0.5; alpha < 1.; alpha += step)
        {
          const auto value = miss_of(alpha);
          if (value && last && *value * *last <= 0)
            {
              double low = alpha - step, high = alpha;
              for (int i = 0; i < 60; ++i)
                {
                  const double middle                        = 0.5 * (low + high);
                  const auto   found                         = miss_of(middle);
                  (found && *found * *last > 0 ? low : high) = middle;
                }
              if (const auto rest = miss_of(high); rest && std::abs(*rest) < 1e-8)
                return high;
            }
          last = value;
        }
      return std::nullopt;
    }
  } // namespace

  ConvergingShock
  find_converging_shock(int dimensions, double exponent)
  {
    SelfSimilarFlow flow{static_cast<double>(dimensions), exponent, 0.};
    if (exponent > 1.)
      for (const bool larger : {true, false})
        if (const auto alpha = find_alpha(flow, larger))
          {
            flow.alpha = *alpha;
            return {flow, *SonicPassage::through(flow, larger)};
          }
    throw InputError("guderley: adiabatic exponent = " + std::to_string(exponent) +
                     ": no analytic converging shock in " + std::to_string(dimensions) + " dimensions");
  }
} // namespace whipple::exact
