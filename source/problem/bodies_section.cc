// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/problem/expression_section.h>
#include <whipple/problem/material_effects.h>
#include <whipple/problem/problem_sections.h>
#include <whipple/scene/plausible.h>
#include <whipple/scene/shape_section.h>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Bodies";

    /// Specific energy of the pressure that the body asks for; density and pressure are those of the solid times its
    /// share of the volume.
    double
    energy_of_pressure(const SceneSection &section, const EquationOfState &eos, double density, double solid_share)
    {
      const double pressure = plausible::pressure(section, "Pressure", section.text("Pressure")) / solid_share;
      try
        {
          return eos.energy_of_pressure(density / solid_share, pressure);
        }
      catch (const StateError &error)
        {
          section.reject("Pressure", std::string("the material has no such state: ") + error.what());
        }
    }

    /// Density (pores included) and specific energy; what is left open is the material at rest: reference density of
    /// the solid, the pores its void law starts with, zero energy.
    template <int dim>
    void
    read_state(const SceneSection &section, const Material &material, Body<dim> &body)
    {
      const EquationOfState &eos         = *material.eos;
      const double           solid_share = 1. - initial_void_fraction(material);
      const auto has_expression          = [&](const std::string &key) { return section.given(key + " expression"); };
      if (!section.given("Density") && !has_expression("Density"))
        section.replace("Density", units::format(solid_share * eos.reference_density(), units::density));
      body.density = section.given("Density") ? section.positive("Density", units::density)
                                              : solid_share * eos.reference_density();

      if (section.given("Pressure") && section.given("Specific energy"))
        section.reject("Pressure", "allowed is a pressure or a specific energy, not both");
      if (section.given("Pressure"))
        {
          body.energy = energy_of_pressure(section, eos, body.density, solid_share);
          return;
        }
      if (!section.given("Specific energy") && !has_expression("Specific energy"))
        section.replace("Specific energy", units::format(0, units::specific_energy));
      body.energy = section.given("Specific energy") ? section.quantity("Specific energy", units::specific_energy) : 0.;
    }

    /// Entries that the exact solution says instead.
    template <int dim>
    void
    check_exact(const SceneSection &section, const Body<dim> &body)
    {
      for (const char *key : {"Density", "Pressure", "Specific energy", "Deposited energy"})
        if (section.given(key))
          section.reject(key, "the initial state is exact: the exact solution gives it; allowed is nothing");
      for (const std::string &key : given_expressions(section))
        section.reject(key, "the initial state is exact: the exact solution gives it; allowed is nothing");
      if (body.velocity != Vector<dim>{})
        section.reject("Velocity", "the initial state is exact: the exact solution gives it; allowed is nothing");
    }

    template <int dim>
    void
    read_body(SceneParameters &parameters, const std::string &name, Problem<dim> &problem)
    {
      Scene<dim>              &scene = problem.scene;
      const SceneSection       section(parameters, path + "/" + name);
      std::vector<std::string> materials;
      for (const SceneMaterial &material : scene.materials)
        materials.push_back(material.name);

      Body<dim> body;
      body.name          = name;
      body.shape         = read_shape<dim>(section, scene);
      body.velocity      = section.vector<dim>("Velocity", units::velocity);
      body.material      = section.name_index("Material", section.text("Material"), materials);
      body.initial_state = section.choice<InitialState>(
          "Initial state", {{"uniform", InitialState::uniform}, {"exact", InitialState::exact}});
      if (body.initial_state == InitialState::exact)
        {
          check_exact(section, body);
          body.density = problem.materials[body.material].model.eos->reference_density();
          scene.bodies.push_back(body);
          problem.body_field.push_back(nullptr);
          return;
        }
      reject_doubles<dim>(section, body);
      read_state(section, problem.materials[body.material].model, body);
      problem.body_field.push_back(read_expressions(section, scene, body));
      if (section.given("Deposited energy"))
        body.deposit = EnergyDeposit<dim>{section.positive("Deposited energy", units::energy),
                                          section.vector<dim>("Deposit point", units::length)};
      else if (section.given("Deposit point"))
        section.reject("Deposit point", "needs a deposited energy");
      scene.bodies.push_back(body);
    }
  } // namespace

  void
  declare_bodies(SceneParameters &parameters, const std::vector<std::string> &names)
  {
    SceneSection(parameters, path).declare("List", "", "names of the bodies; each has its subsection below");
    for (const std::string &name : names)
      {
        SceneSection section(parameters, path + "/" + name);
        declare_shape(section);
        section.declare(
            "Touching", "",
            "a body that it touches at the start, coming along axis 1 (against it with such a velocity); its "
            "place along axis 1 is set by that");
        section.declare("Initial state", "uniform",
                        "uniform | exact: density, energy and velocity of the scene's exact solution");
        section.declare("Velocity", "0 cm/us, 0 cm/us", "along axis 0 and axis 1");
        section.declare("Material", "", "one of Materials/List");
        section.declare("Density", "", "not given: the material's at zero pressure and energy");
        section.declare("Pressure", "", "instead of a specific energy");
        section.declare("Specific energy", "", "not given, and no pressure given: zero");
        declare_expressions(section);
        section.declare("Deposited energy", "", "put into the one cell that holds the deposit point");
        section.declare("Deposit point", "", "inside the body");
      }
  }

  template <int dim>
  void
  read_bodies(SceneParameters &parameters, Problem<dim> &problem)
  {
    const SceneSection section(parameters, path);
    for (const std::string &name : section.list("List"))
      read_body(parameters, name, problem);
    if (problem.scene.bodies.empty())
      section.reject("List", "must be given; allowed are one or more names, each with its subsection");
  }

  template void
  read_bodies(SceneParameters &, Problem<2> &);
} // namespace whipple::sections
