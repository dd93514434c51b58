// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/fluid_point.h>
#include <whipple/exact/uniaxial_loading.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace whipple::exact
{
  namespace
  {
    struct StrengthPoint
    {
      double shear_modulus, yield_stress;
    };

    /// dP/de at constant density.
    double
    energy_slope(const EquationOfState &eos, double density, double energy)
    {
      double density_slope = 0, slope = 0;
      eos.derivatives({&density, 1}, {&energy, 1}, {&density_slope, 1}, {&slope, 1});
      return slope;
    }

    StrengthPoint
    strength_point(const Strength &strength, double density, double energy, double plastic_strain)
    {
      StrengthPoint point{};
      strength.evaluate({{&density, 1}, {&energy, 1}, {}, {&plastic_strain, 1}, {}}, {&point.shear_modulus, 1},
                        {&point.yield_stress, 1});
      return point;
    }
  } // namespace

  UniaxialLoading::UniaxialLoading(const Material &material, double density, double energy)
    : material_(material)
    , initial_{density, fluid_point(*material.eos, density, energy).pressure, 0., energy, 0.}
    , yield_density_(std::numeric_limits<double>::infinity())
  {
    if (!material.strength)
      return;
    if (material.strength->softens())
      throw InputError(
          "exact solution: no waves are known for the strength '" + material.strength->name() +
          "': it must depend on the plastic strain alone, as 'perfectly plastic' and 'linear hardening' do");
    const StrengthPoint point = strength_point(*material.strength, density, energy, 0.);
    if (!(point.yield_stress > 0))
      return;
    shear_modulus_ = point.shear_modulus;
    yield_density_ = density * std::exp(0.5 * point.yield_stress / point.shear_modulus);
  }

  double
  UniaxialLoading::deviator(double density) const
  {
    if (!has_strength())
      return 0.;
    const double strain = std::log(density / initial_.density);
    if (density <= yield_density_)
      return 4. / 3. * shear_modulus_ * strain;
    // plastic strain p on the yield surface: 2 G (2/3 strain - p) = 2/3 Y(p); the left side falls, the right one does
    // not
    double low = 0., high = 2. / 3. * strain;
    for (int i = 0; i < 100; ++i)
      {
        const double middle = 0.5 * (low + high);
        const double yield =
            strength_point(*material_.strength, initial_.density, initial_.energy, middle).yield_stress;
        (2. * shear_modulus_ * (2. / 3. * strain - middle) > 2. / 3. * yield ? low : high) = middle;
      }
    return 2. * shear_modulus_ * (2. / 3. * strain - 0.5 * (low + high));
  }

  std::optional<LoadedState>
  UniaxialLoading::behind_shock(const LoadedState &ahead, double density) const
  {
    if (density >= material_.eos->max_density())
      return std::nullopt;
    const double compression = 1. / ahead.density - 1. / density, s = deviator(density);
    double       energy = ahead.energy;
    // Newton for the energy of the jump condition; one step where P is linear in e
    for (int i = 0; i < 20; ++i)
      {
        const double pressure = fluid_point(*material_.eos, density, energy).pressure;
        const double slope    = 1. - 0.5 * energy_slope(*material_.eos, density, energy) * compression;
        const double residual = energy - ahead.energy - 0.5 * (ahead.stress() + pressure + s) * compression;
        if (!(slope > 0))
          return std::nullopt;
        energy -= residual / slope;
        if (std::abs(residual) <= 1e-15 * std::abs(energy))
          break;
      }
    LoadedState  result{density, fluid_point(*material_.eos, density, energy).pressure, s, energy, ahead.velocity};
    const double square = (result.stress() - ahead.stress()) * compression;
    result.velocity += std::sqrt(std::max(0., square));
    return result;
  }

  WaveFront
  UniaxialLoading::shock(const LoadedState &ahead, double velocity) const
  {
    // chi = 1 - rho_a / rho runs over (0, 1); beyond the pole of the Hugoniot counts as "too fast"
    double low = 0., high = 1.;
    for (int i = 0; i < 200; ++i)
      {
        const double middle                                = 0.5 * (low + high);
        const auto   state                                 = behind_shock(ahead, ahead.density / (1. - middle));
        (state && state->velocity < velocity ? low : high) = middle;
      }
    const auto state = behind_shock(ahead, ahead.density / (1. - low));
    if (!state || std::abs(state->velocity - velocity) > 1e-6 * velocity)
      throw InputError("'" + material_.name + "' has no shock to " + std::to_string(velocity) + " cm/us");
    return {ahead.velocity + (state->stress() - ahead.stress()) / (ahead.density * (velocity - ahead.velocity)),
            *state};
  }

  std::vector<WaveFront>
  UniaxialLoading::fronts(double velocity) const
  {
    if (!(velocity > 0))
      throw InputError("'" + material_.name + "': a piston at " + std::to_string(velocity) +
                       " cm/us drives no shock: must be > 0");
    if (has_strength())
      {
        const auto yield = behind_shock(initial_, yield_density_);
        if (yield && velocity > yield->velocity)
          {
            const WaveFront elastic{(yield->stress() - initial_.stress()) / (initial_.density * yield->velocity),
                                    *yield};
            const WaveFront plastic = shock(*yield, velocity);
            if (plastic.speed < elastic.speed)
              return {elastic, plastic};
          }
      }
    return {shock(initial_, velocity)};
  }

  double
  UniaxialLoading::stress(double velocity) const
  {
    return velocity > 0 ? fronts(velocity).back().behind.stress() : initial_.stress();
  }

  double
  UniaxialLoading::wave_speed(const LoadedState &state) const
  {
    const double bulk = fluid_point(*material_.eos, state.density, state.energy).sound_speed;
    return std::sqrt(bulk * bulk + 4. / 3. * shear_modulus_ / state.density);
  }
} // namespace whipple::exact
