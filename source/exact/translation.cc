// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/fluid_point.h>
#include <whipple/exact/translation.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace whipple::exact
{
  Translation::Translation(std::string name, std::vector<FlyingBody> bodies, double start)
    : ExactSolution<2>(std::move(name))
    , bodies_(std::move(bodies))
    , start_(start)
  {
  }

  PointState<2>
  Translation::at(const Vector<2> &x, double time) const
  {
    PointState<2> state;
    for (const FlyingBody &body : bodies_)
      {
        Vector<2> before = x;
        for (int d = 0; d < 2; ++d)
          before[d] -= body.velocity[d] * (start_ + time);
        if (body.outline.contains(before))
          return {body.density, body.pressure, body.energy, body.velocity};
      }
    state.density  = 0.;
    state.pressure = 0.;
    return state;
  }

  ExactKind
  translation_kind()
  {
    return {"translation", "bodies without pressure in free flight through the vacuum", {}, true};
  }

  std::unique_ptr<const ExactSolution<2>>
  make_translation(const ExactRequest<2> &request)
  {
    std::vector<Translation::FlyingBody> bodies;
    for (const BodyState<2> &body : request.bodies)
      {
        const FluidPoint point = fluid_point(*body.material.eos, body.density, body.energy);
        // rounding of a law's zero, against its modulus
        if (std::abs(point.pressure) > 1e-12 * body.density * point.sound_speed * point.sound_speed)
          {
            std::ostringstream message;
            message << "exact solution '" << request.name << "': body '" << body.name << "' has a pressure of "
                    << point.pressure << " Mbar: must have none";
            throw InputError(message.str());
          }
        bodies.push_back({outline(body), body.velocity, body.density, point.pressure, body.energy});
      }
    return std::make_unique<Translation>(request.name, std::move(bodies), request.start);
  }
} // namespace whipple::exact
