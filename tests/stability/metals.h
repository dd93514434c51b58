// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "scene_text.h"

#include <whipple/exact/riemann.h>
#include <whipple/problem/problem.h>

#include <string>
#include <utility>
#include <vector>

namespace whipple::stability
{
  using Entries = std::vector<std::pair<std::string, std::string>>;

  /// Aluminium as in the published case: perfectly plastic, voids by the rate law above a spall strength.
  inline Entries
  shield_aluminium(const std::string &alpha = "1e5 us/cm^2")
  {
    return {{"Library", "aluminium 2024-T4"},
            {"Strength", "perfectly plastic"},
            {"Yield stress", "345 MPa"},
            {"Void law", "rate"},
            {"Alpha", alpha},
            {"Spall strength", "1.2 GPa"}};
  }

  /// Any metal of the library with strength and voids.
  inline Entries
  metal(const std::string &library)
  {
    return {{"Library", library},
            {"Strength", "perfectly plastic"},
            {"Void law", "rate"},
            {"Alpha", "1e5 us/cm^2"},
            {"Spall strength", "1.2 GPa"}};
  }

  /// A plate across the domain.
  inline Entries
  plate(double front, double thickness, const std::string &material, double speed = 0.)
  {
    return {{"Shape", "plate"},
            {"Front face", cm(front)},
            {"Thickness", cm(thickness)},
            {"Velocity", velocity(0., speed)},
            {"Material", material}};
  }

  inline Entries
  block(double x0, double y0, double x1, double y1, const std::string &material, double v0 = 0., double v1 = 0.)
  {
    return {{"Shape", "box"},
            {"Lower corner", cm(x0, y0)},
            {"Upper corner", cm(x1, y1)},
            {"Velocity", velocity(v0, v1)},
            {"Material", material}};
  }

  inline Entries
  sphere(double x, double y, double diameter, const std::string &material, double v0, double v1)
  {
    return {{"Shape", "sphere"},
            {"Center", cm(x, y)},
            {"Diameter", cm(diameter)},
            {"Velocity", velocity(v0, v1)},
            {"Material", material}};
  }

  /// Behind both shocks of a plane impact, from the equations of state alone.
  struct ImpedanceMatch
  {
    double pressure, velocity;
  };

  /// Impedance match of a striker (speed, cm/us) and a target at rest, without strength.
  inline ImpedanceMatch
  impedance_match(const MaterialModels &striker, const MaterialModels &target, double speed)
  {
    const auto side = [](const MaterialModels &m, double v) {
      return exact::Riemann::State{m.model.eos, m.model.eos->reference_density(), v, 0.};
    };
    const exact::Riemann match(side(striker, speed), side(target, 0.));
    return {match.pressure(), match.velocity()};
  }
} // namespace whipple::stability
