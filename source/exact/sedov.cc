// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/sedov.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace whipple::exact
{
  namespace
  {
    /// Depth of the table: r / R there is at most exp(-400 (k - 1) / (2 k + n - 2)), nothing to any mesh.
    constexpr double deepest    = 400.;
    constexpr int    table_size = 4000;
  } // namespace

  Sedov::Sedov(const Constants &given_constants)
    : constants(given_constants)
  {
    const double k = constants.exponent;
    if (!(k > 1.) || std::abs(k - 2.) < 1e-6 || (constants.dimensions == 3 && k >= 7.))
      throw InputError("sedov: adiabatic exponent = " + std::to_string(k) + ": must be > 1 and not 2" +
                       (constants.dimensions == 3 ? ", and below 7" : ""));
    for (int i = 0; i <= table_size; ++i)
      log_positions.push_back(shape(deepest * i / table_size).log_position);
    energy_integral = integrate_energy();
  }

  Sedov::Shape
  Sedov::shape(double depth) const
  {
    const double k = constants.exponent, n = constants.dimensions;
    const double v0 = 2. / ((n + 2.) * k), v2 = 4. / ((n + 2.) * (k + 1.));
    const double above = (v2 - v0) * std::exp(-depth), v = v0 + above; // V - V0 kept apart: it cancels in x2
    const double a = (n + 2.) * (k + 1.) / 4., b = (k + 1.) / (k - 1.), c = (n + 2.) * k / 2.;
    const double e = (2. + n * (k - 1.)) / 2., d = (n + 2.) * (k + 1.) / ((n + 2.) * (k + 1.) - 4. * e);
    const double x1 = a * v, x2 = b * c * above, x3 = d * (1. - e * v), x4 = b * (1. - c * v / k);

    const double a2 = (1. - k) / (2. * (k - 1.) + n);
    const double a1 = c / e * (2. * n * (2. - k) / (k * (n + 2.) * (n + 2.)) - a2);
    const double a0 = 2. / (n + 2.), a3 = n / (2. * (k - 1.) + n), a4 = (n + 2.) * a1 / (2. - k), a5 = 2. / (k - 2.);
    Shape        s;
    s.log_position = -a0 * std::log(x1) - a2 * std::log(x2) - a1 * std::log(x3);
    s.slope        = a0 * above / v + a2 - a1 * e * above / (1. - e * v);
    s.velocity     = x1 * std::exp(s.log_position);
    s.density      = std::pow(x2, a3) * std::pow(x3, a4) * std::pow(x4, a5);
    s.pressure     = std::pow(x1, a0 * n) * std::pow(x3, a4 - 2. * a1) * std::pow(x4, 1. + a5);
    return s;
  }

  double
  Sedov::integrate_energy() const
  {
    // energy / (rho0 R^(n+2) / t^2), per direction, by Simpson's rule over the depth
    const double k = constants.exponent, n = constants.dimensions;
    const double shock_speed = 2. / (n + 2.), u2 = 2. * shock_speed / (k + 1.);
    const double rho2 = (k + 1.) / (k - 1.), p2 = 2. * shock_speed * shock_speed / (k + 1.);
    const auto   integrand = [&](double depth) {
      const Shape  s = shape(depth);
      const double u = u2 * s.velocity;
      return (0.5 * rho2 * s.density * u * u + p2 * s.pressure / (k - 1.)) * -s.slope * std::exp(n * s.log_position);
    };
    constexpr int steps = 40000;
    const double  h     = deepest / steps;
    double        sum   = integrand(0.) + integrand(deepest);
    for (int i = 1; i < steps; ++i)
      sum += (i % 2 ? 4. : 2.) * integrand(h * i);
    const double directions = n == 1 ? 1. : 2. * (n - 1.) * std::numbers::pi;
    return directions * sum * h / 3.;
  }

  double
  Sedov::depth_at(double log_position) const
  {
    const auto   below = std::lower_bound(log_positions.begin() + 1, log_positions.end() - 1, log_position,
                                          [](double a, double b) { return a > b; });
    const double lower = *(below - 1), upper = *below;
    double       depth = deepest / table_size *
                   (below - 1 - log_positions.begin() + std::clamp((lower - log_position) / (lower - upper), 0., 1.));
    // Newton from the table's linear guess
    for (int i = 0; i < 4; ++i)
      {
        const Shape s = shape(depth);
        depth         = std::clamp(depth - (s.log_position - log_position) / s.slope, 0., deepest);
      }
    return depth;
  }

  ProfileState
  Sedov::at(double coordinate, double time) const
  {
    const double r = std::abs(coordinate), radius = *shock_position(time);
    if (!(r < radius))
      return {constants.density, 0., 0., 0.};
    const double k           = constants.exponent;
    const double shock_speed = 2. / (constants.dimensions + 2.) * radius / time;
    const Shape  s           = shape(depth_at(std::log(r / radius)));
    const double density     = constants.density * (k + 1.) / (k - 1.) * s.density;
    const double pressure    = 2. * constants.density * shock_speed * shock_speed / (k + 1.) * s.pressure;
    // towards the centre the specific energy grows without bound: no error can be measured against it there
    const double energy = density > 1e-2 * constants.density ? pressure / ((k - 1.) * density) : not_given;
    return {density, std::copysign(2. * shock_speed / (k + 1.) * s.velocity, coordinate), pressure, energy};
  }

  bool
  Sedov::counts(double, double time) const
  {
    return *shock_position(time) < constants.extent;
  }

  std::vector<double>
  Sedov::breaks(double time) const
  {
    return {*shock_position(time)};
  }

  std::optional<double>
  Sedov::shock_position(double time) const
  {
    return std::pow(constants.energy * time * time / (energy_integral * constants.density),
                    1. / (constants.dimensions + 2.));
  }

  ExactKind
  sedov_kind()
  {
    return {
        "sedov",
        "explosion in a plane, line or point of a cold ideal gas; density, exponent and deposited energy of the one "
        "body (L. I. Sedov, Similarity and Dimensional Methods in Mechanics, 1959)",
        {{"Total energy", "energy", 0.,
          "released in all of space (spherical), per cm (cylindrical), per cm^2 and to one side (planar); 0: what the "
          "body's deposited energy makes of it, doubled for each side at coordinate 0 that reflects"}}};
  }

  namespace
  {
    /// The solution's energy that the deposit in the domain stands for.
    double
    energy_of_deposit(const ExactRequest<2> &request, double deposit)
    {
      if (!(deposit > 0))
        throw InputError("exact solution '" + request.name +
                         "': give 'Total energy' or a body with 'Deposited energy'");
      const bool revolved = request.symmetry == Symmetry::axisymmetric;
      const auto mirrored = [&](int axis) {
        return request.lower[axis] == 0 && request.boundaries[2 * axis].kind == BoundaryKind::reflecting ? 2. : 1.;
      };
      const double width = request.upper[0] - request.lower[0], height = request.upper[1] - request.lower[1];
      switch (request.geometry)
        {
        case Geometry::planar:
          return 0.5 * deposit * mirrored(1) / (revolved ? std::numbers::pi * width * width : width);
        case Geometry::cylindrical:
          return revolved ? deposit / height : deposit * mirrored(0) * mirrored(1);
        case Geometry::spherical:
          break;
        }
      return deposit * mirrored(1);
    }
  } // namespace

  std::unique_ptr<const ExactSolution<2>>
  make_sedov(const ExactRequest<2> &request)
  {
    const IdealGasState gas    = only_gas(request);
    const double        total  = constant(request, "Total energy");
    const double        energy = total > 0 ? total : energy_of_deposit(request, request.bodies.front().deposit);
    return in_plane(request, std::make_unique<Sedov>(Sedov::Constants{space_dimensions(request), gas.exponent,
                                                                      gas.density, energy, extent(request)}));
  }
} // namespace whipple::exact
