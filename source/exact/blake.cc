// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/exact/blake.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/solid_request.h>

#include <cmath>

namespace whipple::exact
{
  Blake::Blake(const Constants &given_constants)
    : constants(given_constants)
    , wave_speed_(
          std::sqrt((given_constants.bulk_modulus + 4. / 3. * given_constants.shear_modulus) / given_constants.density))
    , damping_(2. * given_constants.shear_modulus / (given_constants.density * wave_speed_ * given_constants.radius))
    , frequency_(std::sqrt(4. * given_constants.shear_modulus /
                               (given_constants.density * given_constants.radius * given_constants.radius) -
                           damping_ * damping_))
  {
  }

  Blake::Elastic
  Blake::elastic(double radius, double time) const
  {
    const double r = radius, a = constants.radius, c = wave_speed_, b = damping_, w = frequency_;
    const double s = time - (r - a) / c;
    if (s < 0)
      return {};
    const double shear = constants.shear_modulus, scale = -0.25 * constants.pressure * a * a * a / shear;
    const double decay = std::exp(-b * s), cosine = std::cos(w * s), sine = std::sin(w * s);
    const double potential = scale * (1. - decay * (cosine + b / w * sine));
    const double first     = scale * decay * (b * b + w * w) / w * sine;
    const double second    = scale * decay * (b * b + w * w) * (cosine - b / w * sine);

    Elastic result;
    result.displacement  = -first / (c * r) - potential / (r * r);
    result.velocity      = -second / (c * r) - first / (r * r);
    result.dilatation    = second / (c * c * r);
    const double stretch = result.dilatation - 2. * result.displacement / r; // du/dr
    const double lame    = constants.bulk_modulus - 2. / 3. * shear;
    result.radial        = lame * result.dilatation + 2. * shear * stretch;
    result.hoop          = lame * result.dilatation + 2. * shear * result.displacement / r;
    return result;
  }

  ProfileState
  Blake::at(double coordinate, double time) const
  {
    const Elastic state = elastic(coordinate, time);
    return {constants.density * (1. - state.dilatation), state.velocity, -constants.bulk_modulus * state.dilatation,
            not_given};
  }

  bool
  Blake::counts(double coordinate, double time) const
  {
    return constants.rim - coordinate > wave_speed_ * time - (constants.rim - constants.radius);
  }

  std::vector<double>
  Blake::breaks(double time) const
  {
    return {constants.radius + wave_speed_ * time};
  }

  ExactKind
  blake_kind()
  {
    return {"blake",
            "pressure in a spherical cavity of a linear elastic solid; elastic constants of the one body (F. G. Blake, "
            "J. Acoust. Soc. Am. 24 (1952) 211)",
            {{"Cavity radius", "length", 10., "of the undeformed cavity around the origin"},
             {"Cavity pressure", "pressure", 1e-5, "from the start of the run on"}}};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_blake(const ExactRequest<2> &request)
  {
    const ElasticConstants elastic = only_elastic_solid(request);
    Blake::Constants       constants;
    constants.density         = elastic.density;
    constants.bulk_modulus    = elastic.bulk_modulus;
    constants.shear_modulus   = elastic.shear_modulus;
    constants.radius          = positive_constant(request, "Cavity radius");
    constants.pressure        = positive_constant(request, "Cavity pressure");
    constants.rim             = extent(request);
    ExactRequest<2> spherical = request;
    spherical.geometry        = Geometry::spherical;
    return in_plane(spherical, std::make_unique<Blake>(constants));
  }
} // namespace whipple::exact
