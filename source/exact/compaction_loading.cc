// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/compaction_loading.h>
#include <whipple/exact/fluid_point.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace whipple::exact
{
  CompactionLoading::CompactionLoading(std::shared_ptr<const EquationOfState> eos, const PAlphaVoidLaw::Constants &law,
                                       double density, double energy)
    : eos_(std::move(eos))
    , law_(law)
  {
    const double alpha = 1. / (1. - law.initial_porosity);
    initial_           = {density, fluid_point(*eos_, alpha * density, energy).pressure / alpha, 0., energy, 0.};
    if (initial_.pressure > law.elastic_crush_pressure)
      {
        std::ostringstream message;
        message << eos_->name() << ": porous material of " << density << " g/cm^3 has a pressure of "
                << initial_.pressure << " Mbar: must be at most the elastic crush pressure, "
                << law.elastic_crush_pressure << " Mbar";
        throw InputError(message.str());
      }
  }

  double
  CompactionLoading::distension(double pressure) const
  {
    const double pore_ratio = law_.initial_porosity / (1. - law_.initial_porosity);
    if (pressure <= law_.elastic_crush_pressure)
      return 1. + pore_ratio;
    if (pressure >= law_.full_compaction_pressure)
      return 1.;
    const double share =
        (law_.full_compaction_pressure - pressure) / (law_.full_compaction_pressure - law_.elastic_crush_pressure);
    return 1. + pore_ratio * share * share;
  }

  std::optional<LoadedState>
  CompactionLoading::behind_shock(const LoadedState &ahead, double pressure) const
  {
    const double alpha  = distension(pressure);
    const auto   behind = [&](double true_density) {
      const double shrinkage = 1. / ahead.density - alpha / true_density;
      return fluid_point(*eos_, true_density, ahead.energy + 0.5 * (ahead.pressure + pressure) * shrinkage);
    };
    // P_s on that line rises with the true density from the one that keeps the volume; towards a pole without bound
    const double limit = eos_->max_density();
    double       low = alpha * ahead.density, high = low;
    do
      {
        low  = high;
        high = std::isfinite(limit) ? 0.5 * (low + limit) : 2. * low;
        if (!(high > low && high < 1e6 * ahead.density && high < limit))
          return std::nullopt;
      }
    while (behind(high).pressure < alpha * pressure);
    for (int i = 0; i < 100; ++i)
      {
        const double middle                                       = 0.5 * (low + high);
        (behind(middle).pressure < alpha * pressure ? low : high) = middle;
      }
    const double jump = std::sqrt((pressure - ahead.pressure) * (1. / ahead.density - alpha / high));
    return LoadedState{high / alpha, pressure, 0., behind(high).energy, ahead.velocity + jump};
  }

  WaveFront
  CompactionLoading::shock(const LoadedState &ahead, double velocity) const
  {
    // a pressure that the law does not reach counts as "too fast"
    const auto too_slow = [&](double pressure) {
      const auto state = behind_shock(ahead, pressure);
      return state && state->velocity < velocity;
    };
    const double du  = velocity - ahead.velocity;
    double       low = ahead.pressure, high = ahead.pressure + ahead.density * du * du;
    while (too_slow(high))
      {
        low  = high;
        high = ahead.pressure + 2. * (high - ahead.pressure);
      }
    for (int i = 0; i < 100; ++i)
      {
        const double middle             = 0.5 * (low + high);
        (too_slow(middle) ? low : high) = middle;
      }
    const auto behind = behind_shock(ahead, low);
    if (!behind || std::abs(behind->velocity - velocity) > 1e-6 * velocity)
      throw InputError("'" + eos_->name() + "' has no compaction shock to " + std::to_string(velocity) + " cm/us");
    return {ahead.velocity + (behind->pressure - ahead.pressure) / (ahead.density * (velocity - ahead.velocity)),
            *behind};
  }

  std::vector<WaveFront>
  CompactionLoading::fronts(double velocity) const
  {
    if (!(velocity > 0))
      throw InputError("'" + eos_->name() + "': a piston at " + std::to_string(velocity) +
                       " cm/us drives no shock: must be > 0");
    if (law_.elastic_crush_pressure > initial_.pressure)
      {
        const auto yield = behind_shock(initial_, law_.elastic_crush_pressure);
        if (yield && velocity > yield->velocity)
          {
            const WaveFront precursor{(yield->pressure - initial_.pressure) / (initial_.density * yield->velocity),
                                      *yield};
            const WaveFront compaction = shock(*yield, velocity);
            if (compaction.speed < precursor.speed)
              return {precursor, compaction};
          }
      }
    return {shock(initial_, velocity)};
  }

  double
  CompactionLoading::wave_speed(const LoadedState &state) const
  {
    return fluid_point(*eos_, distension(state.pressure) * state.density, state.energy).sound_speed;
  }
} // namespace whipple::exact
