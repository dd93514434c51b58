// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/sections.h>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Numerics";
  }

  void
  declare_numerics(SceneParameters &parameters)
  {
    const Numerics defaults;
    SceneSection   section(parameters, path);
    const auto     declare = [&](const char *key, double value, const char *documentation) {
      section.declare(key, units::format(value, units::number), documentation);
    };
    declare("Courant number", defaults.hydro.courant, "part of the acoustic time step, 0 < C <= 1");
    declare("Volume change limit", defaults.hydro.max_volume_change, "largest relative volume change in a step");
    declare("Advection limit", defaults.advection_limit, "largest displacement of a node in a step, in cell edges");
    declare("Time step growth", defaults.growth_limit, "largest ratio of one time step to the last");
    section.declare("Viscosity", "scalar", "scalar (a pressure) | tensor (a stress along the compression)");
    declare("Linear viscosity", defaults.hydro.linear_viscosity, "coefficient of the artificial viscosity");
    declare("Quadratic viscosity", defaults.hydro.quadratic_viscosity, "coefficient of the artificial viscosity");
    declare("Hourglass coefficient", defaults.hydro.hourglass, "resistance to hourglass motion");
    section.declare("Remap order", std::to_string(defaults.remap_order), "1: donor cell; 2: limited linear");
    section.declare("Inject failure at step", "none", "test hook: the state goes bad in this step of the run ...");
    section.declare("Injected failures", "always", "... always | in so many tries of it");
  }

  Numerics
  read_numerics(SceneParameters &parameters)
  {
    constexpr double   least = 1e-6; // smaller factors could as well be zero, and would never end
    const SceneSection section(parameters, path);
    Numerics           numerics;
    numerics.hydro.courant           = section.between("Courant number", units::number, least, 1);
    numerics.hydro.max_volume_change = section.between("Volume change limit", units::number, least, 0.5);
    numerics.advection_limit         = section.between("Advection limit", units::number, least, 0.5);
    numerics.growth_limit            = section.between("Time step growth", units::number, 1.001, 10);
    numerics.hydro.viscosity         = section.choice<ViscosityKind>(
        "Viscosity", {{"scalar", ViscosityKind::scalar}, {"tensor", ViscosityKind::tensor}});
    numerics.hydro.linear_viscosity    = section.non_negative("Linear viscosity", units::number);
    numerics.hydro.quadratic_viscosity = section.non_negative("Quadratic viscosity", units::number);
    numerics.hydro.hourglass           = section.non_negative("Hourglass coefficient", units::number);
    numerics.remap_order               = section.integer("Remap order", 1, 2);
    if (section.text("Inject failure at step") != "none")
      numerics.inject_failure_at_step = section.integer("Inject failure at step", 1, 1000000000);
    if (section.text("Injected failures") != "always")
      numerics.injected_failures = section.integer("Injected failures", 0, 1000);
    return numerics;
  }
} // namespace whipple::sections
