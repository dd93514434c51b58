// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/coggeshall.h>
#include <whipple/exact/profile_request.h>

#include <cmath>

namespace whipple::exact
{
  Coggeshall::Coggeshall(const Constants &given_constants)
    : constants(given_constants)
    , rim(
          [this](double r, double t) {
            const ProfileState s = at(r, t);
            return s.velocity - std::sqrt(this->constants.exponent * s.pressure / s.density);
          },
          given_constants.extent, given_constants.start, 1e-3 * given_constants.start, [](double) { return 0.; })
  {
  }

  ProfileState
  Coggeshall::at(double coordinate, double time) const
  {
    const double n = constants.dimensions, k = constants.exponent, b = constants.power;
    const double density  = constants.density * std::pow(coordinate, b) * std::pow(time, -b - n);
    const double pressure = constants.pressure * std::pow(time, -k * n);
    return {density, coordinate / time, pressure, pressure / ((k - 1.) * density)};
  }

  bool
  Coggeshall::counts(double coordinate, double time) const
  {
    return rim.not_yet_at(coordinate, time);
  }

  namespace
  {
    const ExactConstant density{"Density", "density", 1., "at 1 cm and 1 us"};
    const ExactConstant pressure{"Pressure", "pressure", 0.01, "everywhere at 1 us"};

    std::unique_ptr<const ExactSolution<2>>
    make(const ExactRequest<2> &request, double power)
    {
      if (!(request.start > 0))
        throw InputError("exact solution '" + request.name + "': start = " + std::to_string(request.start) +
                         " us: must be > 0, everything is at r = 0 at time 0");
      return in_plane(request, std::make_unique<Coggeshall>(Coggeshall::Constants{
                                   space_dimensions(request), only_gas(request).exponent, power,
                                   positive_constant(request, density.key), positive_constant(request, pressure.key),
                                   extent(request), request.start}));
    }
  } // namespace

  ExactKind
  coggeshall_1_kind()
  {
    return {
        "coggeshall 1",
        "free expansion u = r/t with density ~ r^b and uniform pressure; exponent of the one body (S. V. Coggeshall, "
        "Phys. Fluids A 3 (1991) 757)",
        {density, pressure, {"Density power", "pure number", 0., "b of the density r^b"}}};
  }

  ExactKind
  coggeshall_8_kind()
  {
    return {"coggeshall 8",
            "free expansion u = r/t in which heat conduction ~ density^alpha temperature^(beta+3) changes nothing; "
            "exponent of the one body (S. V. Coggeshall, Phys. Fluids A 3 (1991) 757)",
            {density,
             pressure,
             {"Alpha", "pure number", -1., "power of the density in the conductivity"},
             {"Beta", "pure number", 2., "3 less than the power of the temperature in the conductivity"}}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_coggeshall_1(const ExactRequest<2> &request)
  {
    return make(request, constant(request, "Density power"));
  }

  std::unique_ptr<const ExactSolution<2>>
  make_coggeshall_8(const ExactRequest<2> &request)
  {
    const double alpha = constant(request, "Alpha"), beta = constant(request, "Beta");
    if (beta - alpha + 4. == 0.)
      throw InputError("exact solution '" + request.name + "': Alpha = " + std::to_string(alpha) +
                       ": must not be Beta + 4");
    return make(request, (space_dimensions(request) - 2.) / (beta - alpha + 4.));
  }
} // namespace whipple::exact
