// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/fluid_point.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/solid_request.h>
#include <whipple/exact/sound_wave.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

namespace whipple::exact
{
  namespace
  {
    constexpr double pi = std::numbers::pi;

    /// A constant that counts half waves.
    int
    mode(const ExactRequest<2> &request, const std::string &key)
    {
      const double value = constant(request, key);
      if (value >= 0 && value <= 100 && value == std::floor(value))
        return static_cast<int>(value);
      std::ostringstream message;
      message << "exact solution '" << request.name << "': " << key << " = " << value
              << ": must be a whole number from 0 to 100";
      throw InputError(message.str());
    }
  } // namespace

  double
  bessel_j1_zero(int n)
  {
    // the zeros lie one in each interval (n pi, (n + 1/2) pi)
    double     low = n * pi, high = (n + 0.5) * pi;
    const bool rising = std::cyl_bessel_j(1., high) > 0;
    for (int i = 0; i < 100; ++i)
      {
        const double middle                                          = 0.5 * (low + high);
        ((std::cyl_bessel_j(1., middle) > 0) == rising ? high : low) = middle;
      }
    return 0.5 * (low + high);
  }

  SoundWave::SoundWave(std::string name, const Constants &given_constants)
    : ExactSolution<2>(std::move(name))
    , constants(given_constants)
  {
    const FluidPoint rest = fluid_point(*constants.eos, constants.density, constants.energy);
    pressure_             = rest.pressure;
    sound_speed_          = rest.sound_speed;
    frequency_            = sound_speed_ * std::hypot(constants.wave_number[0], constants.wave_number[1]);
  }

  PointState<2>
  SoundWave::at(const Vector<2> &x, double time) const
  {
    const double *q     = constants.wave_number.data();
    const double  phase = frequency_ * (constants.start + time);
    const double  a = q[0] * (x[0] - constants.lower[0]), b = q[1] * (x[1] - constants.lower[1]);
    const bool    round  = constants.symmetry == Symmetry::axisymmetric;
    const double  shape  = round ? std::cyl_bessel_j(0., std::abs(a)) : std::cos(a);
    const double  slope  = round ? -std::copysign(std::cyl_bessel_j(1., std::abs(a)), a) : -std::sin(a);
    const double  swing  = constants.amplitude * sound_speed_ * sound_speed_ / frequency_ * std::sin(phase);
    const double  strain = constants.amplitude * shape * std::cos(b) * std::cos(phase);

    PointState<2> state;
    state.density  = constants.density * (1. + strain);
    state.pressure = pressure_ + constants.density * sound_speed_ * sound_speed_ * strain;
    state.energy   = constants.energy + pressure_ / constants.density * strain;
    state.velocity = {{-swing * q[0] * slope * std::cos(b), swing * q[1] * shape * std::sin(b)}};
    return state;
  }

  ExactKind
  sound_wave_kind()
  {
    return {"sound wave",
            "standing wave of small amplitude in the closed domain, which the one body fills; no strength",
            {uniform_density,
             uniform_pressure,
             {"Amplitude", "pure number", 1e-6, "largest relative change of the density"},
             {"Half waves along axis 0", "pure number", 1., "0 to 100; axisymmetric: number of the zero of J_1"},
             {"Half waves along axis 1", "pure number", 1., "0 to 100"}}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_sound_wave(const ExactRequest<2> &request)
  {
    const std::string   what  = "exact solution '" + request.name + "': ";
    const BodyState<2> &body  = only_fluid(request);
    const UniformFluid  fluid = uniform_fluid(request, body);
    for (const Boundary<2> &side : request.boundaries)
      if (side.kind != BoundaryKind::reflecting)
        throw InputError(what + "all sides of the domain must be 'reflecting'");
    const int across = mode(request, "Half waves along axis 0"), along = mode(request, "Half waves along axis 1");
    if (across + along == 0)
      throw InputError(what + "needs a half wave along one axis at least");

    SoundWave::Constants constants;
    constants.eos            = body.material.eos;
    constants.density        = fluid.density;
    constants.energy         = fluid.energy;
    constants.symmetry       = request.symmetry;
    constants.lower          = request.lower;
    constants.amplitude      = positive_constant(request, "Amplitude");
    constants.start          = request.start;
    const double reach       = request.upper[0] - request.lower[0];
    const bool   round       = request.symmetry == Symmetry::axisymmetric;
    constants.wave_number[0] = across == 0 ? 0. : (round ? bessel_j1_zero(across) : across * pi) / reach;
    constants.wave_number[1] = along * pi / (request.upper[1] - request.lower[1]);
    return std::make_unique<SoundWave>(request.name, constants);
  }
} // namespace whipple::exact
