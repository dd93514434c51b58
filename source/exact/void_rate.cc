// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/solid_request.h>
#include <whipple/exact/void_rate.h>

#include <cmath>
#include <limits>
#include <utility>

namespace whipple::exact
{
  VoidRate::VoidRate(const Constants &given_constants)
    : constants(given_constants)
    , rate_(given_constants.alpha * given_constants.bulk_modulus / given_constants.reference_density)
    , start_ratio_(given_constants.bulk_density /
                   ((1. - given_constants.void_fraction) * given_constants.reference_density))
  {
  }

  double
  VoidRate::clock(double density_ratio)
  {
    return -std::log(std::abs(density_ratio - 1.) / density_ratio) - 1. / density_ratio;
  }

  double
  VoidRate::density_ratio(double time) const
  {
    if (start_ratio_ == 1.)
      return 1.;
    // bisection in the logarithm of the distance to equilibrium, so that late times resolve too; g^2 <= max(g0, 1)^2
    // bounds how fast that distance falls
    const double since = rate_ * time, target = clock(start_ratio_) + since;
    const double sign = start_ratio_ > 1. ? 1. : -1., begin = std::log(std::abs(start_ratio_ - 1.));
    double       near = begin - since * (start_ratio_ * start_ratio_ + 1.) - 2., far = begin;
    for (int i = 0; i < 200; ++i)
      {
        const double middle                                         = 0.5 * (near + far);
        (clock(1. + sign * std::exp(middle)) > target ? near : far) = middle;
      }
    return 1. + sign * std::exp(0.5 * (near + far));
  }

  double
  VoidRate::void_fraction(double time) const
  {
    return 1. - constants.bulk_density / (constants.reference_density * density_ratio(time));
  }

  double
  VoidRate::solid_pressure(double time) const
  {
    return constants.bulk_modulus * (density_ratio(time) - 1.);
  }

  double
  VoidRate::closing_time() const
  {
    const double closed = constants.bulk_density / constants.reference_density;
    if (!(start_ratio_ > 1. && closed > 1.))
      return std::numeric_limits<double>::infinity();
    return (clock(closed) - clock(start_ratio_)) / rate_;
  }

  VoidRelaxation::VoidRelaxation(std::string name, const VoidRate &law, double density, double energy, double start)
    : ExactSolution<2>(std::move(name))
    , law_(law)
    , density_(density)
    , energy_(energy)
    , start_(start)
  {
  }

  PointState<2>
  VoidRelaxation::at(const Vector<2> &, double time) const
  {
    const double since = start_ + time;
    return {density_, (1. - law_.void_fraction(since)) * law_.solid_pressure(since), energy_, {{0., 0.}}};
  }

  ExactKind
  void_relaxation_kind()
  {
    return {
        "void relaxation",
        "a body at rest under tension, confined, opens by the rate law of voids; linear polynomial law with C1 alone, "
        "spall strength 0",
        {}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_void_relaxation(const ExactRequest<2> &request)
  {
    const std::string      what = "exact solution '" + request.name + "': ";
    const BodyState<2>    &body = only_fluid(request);
    const MaterialRequest &law  = body.constants;
    const double           c1 = law.constant_or("C1", 0.), alpha = law.constant_or("Alpha", 0.);
    if (law.equation_of_state != "linear polynomial" || c1 == 0. || law.constant_or("C2", 0.) != 0. ||
        law.constant_or("C3", 0.) != 0. || law.constant_or("C4", 0.) != 0. || law.constant_or("C5", 0.) != 0. ||
        law.constant_or("C6", 0.) != 0.)
      throw InputError(what + "body '" + body.name + "' must have a 'linear polynomial' law with C1 alone");
    if (law.void_law != "rate" || !body.material.void_law || law.constant_or("Spall strength", 0.) != 0. ||
        !std::isfinite(alpha))
      throw InputError(what + "body '" + body.name +
                       "' must have the void law 'rate' with a finite Alpha and no spall strength, and the effect "
                       "'voids' on");
    const double reference = body.material.eos->reference_density();
    if (body.velocity != Vector<2>{} || !(body.density < reference))
      throw InputError(what + "body '" + body.name + "' must be at rest and below its reference density");
    return std::make_unique<VoidRelaxation>(request.name,
                                            VoidRate(VoidRate::Constants{reference, c1, alpha, body.density, 0.}),
                                            body.density, body.energy, request.start);
  }
} // namespace whipple::exact
