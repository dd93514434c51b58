// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/cold_curve.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace whipple
{
  namespace
  {
    constexpr int    points          = 400;
    constexpr double most_compressed = 6.;   // densities of the state's
    constexpr double short_of_pole   = 0.98; // of the law's largest density

    double
    pressure(const EquationOfState &eos, double true_density, double energy)
    {
      const std::array<double, 1> g{{true_density}}, e{{energy}};
      std::array<double, 1>       p, c2;
      eos.evaluate(g, e, p, c2);
      return p[0];
    }

    /// de/dlog(gamma) along an isentrope.
    double
    slope(const EquationOfState &eos, double true_density, double energy)
    {
      return pressure(eos, true_density, energy) / true_density;
    }
  } // namespace

  ColdCurve::ColdCurve(const EquationOfState &eos, double density, double energy)
    : density_(density)
    , energy_{energy}
  {
    const double last = std::min(most_compressed * density, short_of_pole * eos.max_density());
    step_             = std::log(std::max(last / density, 1.)) / points;
    for (int i = 0; i < points && step_ > 0; ++i)
      {
        const double e = energy_.back(), true_density = density * std::exp(i * step_),
                     middle = true_density * std::exp(0.5 * step_);
        const double k1 = slope(eos, true_density, e), k2 = slope(eos, middle, e + 0.5 * step_ * k1);
        const double k3   = slope(eos, middle, e + 0.5 * step_ * k2),
                     k4   = slope(eos, density * std::exp((i + 1) * step_), e + step_ * k3);
        const double next = e + step_ / 6. * (k1 + 2. * (k2 + k3) + k4);
        if (!std::isfinite(next))
          break;
        energy_.push_back(std::max(next, energy)); // tension just above the state's density is no bound
      }
  }

  double
  ColdCurve::energy(double true_density) const
  {
    if (!(true_density > density_) || energy_.size() < 2)
      return energy_.front();
    const double      x = std::log(true_density / density_) / step_;
    const std::size_t i = std::min(static_cast<std::size_t>(x), energy_.size() - 2);
    return energy_[i] + std::min(x - static_cast<double>(i), 1.) * (energy_[i + 1] - energy_[i]);
  }
} // namespace whipple
