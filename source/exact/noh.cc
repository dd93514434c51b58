// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/exact/noh.h>
#include <whipple/exact/profile_request.h>

#include <cmath>

namespace whipple::exact
{
  Noh::Noh(const Constants &given_constants)
    : constants(given_constants)
    , shock_speed(0.5 * (given_constants.exponent - 1.) * given_constants.velocity)
  {
  }

  ProfileState
  Noh::at(double coordinate, double time) const
  {
    const double k = constants.exponent, u = constants.velocity;
    if (coordinate < shock_speed * time)
      {
        const double density = constants.density * std::pow((k + 1.) / (k - 1.), constants.dimensions);
        const double energy  = 0.5 * u * u;
        return {density, 0., (k - 1.) * density * energy, energy};
      }
    // at the centre and time 0 the shock already stands: nothing lies ahead of it there
    const double gathered = time > 0 ? 1. + u * time / coordinate : 1.;
    return {constants.density * std::pow(gathered, constants.dimensions - 1), -u, 0., 0.};
  }

  bool
  Noh::counts(double coordinate, double time) const
  {
    return coordinate < 0.95 * constants.extent - constants.velocity * time;
  }

  std::vector<double>
  Noh::breaks(double time) const
  {
    return {shock_speed * time};
  }

  std::optional<double>
  Noh::shock_position(double time) const
  {
    return shock_speed * time;
  }

  ExactKind
  noh_kind()
  {
    return {"noh",
            "cold ideal gas that falls onto a plane, line or point; density and exponent of the one body (W. F. Noh, "
            "J. Comput. Phys. 72 (1987) 78)",
            {{"Infall velocity", "velocity", 1., "speed at which the gas falls"}}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_noh(const ExactRequest<2> &request)
  {
    const IdealGasState gas = only_gas(request);
    return in_plane(
        request, std::make_unique<Noh>(Noh::Constants{space_dimensions(request), gas.exponent, gas.density,
                                                      positive_constant(request, "Infall velocity"), extent(request)}));
  }
} // namespace whipple::exact
