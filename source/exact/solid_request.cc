// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/fluid_point.h>
#include <whipple/exact/profile_request.h>
#include <whipple/exact/solid_request.h>

#include <cmath>
#include <sstream>

namespace whipple::exact
{
  const BodyState<2> &
  only_body(const ExactRequest<2> &request)
  {
    if (request.bodies.size() != 1)
      throw InputError("exact solution '" + request.name + "': the scene has " + std::to_string(request.bodies.size()) +
                       " bodies: must have one");
    return request.bodies.front();
  }

  double
  ElasticConstants::wave_speed() const
  {
    return std::sqrt((bulk_modulus + 4. / 3. * shear_modulus) / density);
  }

  ElasticConstants
  elastic_constants(const BodyState<2> &body)
  {
    ElasticConstants constants;
    const FluidPoint point = fluid_point(*body.material.eos, body.density, body.energy);
    constants.density      = body.density;
    constants.bulk_modulus = body.density * point.sound_speed * point.sound_speed;
    if (body.material.strength)
      {
        const double        zero = 0;
        double              yield_stress;
        const StrengthInput state{{&body.density, 1}, {&body.energy, 1}, {&point.pressure, 1}, {&zero, 1}, {&zero, 1}};
        body.material.strength->evaluate(state, {&constants.shear_modulus, 1}, {&yield_stress, 1});
      }
    return constants;
  }

  const ExactConstant uniform_density{"Density", "density", 1., "of the undisturbed fluid"};
  const ExactConstant uniform_pressure{"Pressure", "pressure", 1., "of the undisturbed fluid"};

  UniformFluid
  uniform_fluid(const ExactRequest<2> &request, const BodyState<2> &body)
  {
    const double density = positive_constant(request, "Density"), pressure = constant(request, "Pressure");
    try
      {
        const UniformFluid fluid{density, body.material.eos->energy_of_pressure(density, pressure)};
        if (fluid_point(*body.material.eos, fluid.density, fluid.energy).sound_speed > 0)
          return fluid;
      }
    catch (const StateError &)
      {
      }
    std::ostringstream message;
    message << "exact solution '" << request.name << "': body '" << body.name << "' has no state with a density of "
            << density << " g/cm^3 and a pressure of " << pressure << " Mbar in which sound travels";
    throw InputError(message.str());
  }

  ElasticConstants
  only_elastic_solid(const ExactRequest<2> &request)
  {
    const BodyState<2> &body = only_body(request);
    if (!body.material.strength)
      throw InputError("exact solution '" + request.name + "': body '" + body.name +
                       "' has no strength: its material must be 'perfectly plastic' or 'linear hardening', and the "
                       "effect 'strength' on");
    return elastic_constants(body);
  }

  const BodyState<2> &
  only_fluid(const ExactRequest<2> &request)
  {
    const BodyState<2> &body = only_body(request);
    if (body.material.strength)
      throw InputError("exact solution '" + request.name + "': body '" + body.name + "' must not have strength");
    return body;
  }
} // namespace whipple::exact
