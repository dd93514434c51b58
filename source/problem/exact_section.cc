// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/exact/exact_factory.h>
#include <whipple/problem/problem_sections.h>
#include <whipple/scene/sections.h>
#include <whipple/scene/sphere_shape.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Exact solution";

    const std::vector<std::pair<std::string, exact::Geometry>> geometries{{"planar", exact::Geometry::planar},
                                                                          {"cylindrical", exact::Geometry::cylindrical},
                                                                          {"spherical", exact::Geometry::spherical}};

    const units::Quantity &
    quantity_of(const exact::ExactConstant &constant)
    {
      const units::Quantity *quantity = units::find_quantity(constant.quantity);
      if (!quantity)
        throw Error("exact solutions: constant '" + constant.key + "' has the quantity '" + constant.quantity +
                    "', which is none of scene/units.h");
      return *quantity;
    }

    /// Constants of the chosen kind, defaults made explicit; those of other kinds must not be there.
    std::map<std::string, double>
    read_constants(const SceneSection &section, const std::vector<exact::ExactKind> &kinds,
                   const exact::ExactKind *kind)
    {
      std::map<std::string, double> values;
      std::string                   allowed;
      if (kind)
        for (const exact::ExactConstant &constant : kind->constants)
          {
            const units::Quantity &quantity = quantity_of(constant);
            if (!section.given(constant.key))
              section.replace(constant.key, units::format(constant.default_value, quantity));
            values[constant.key] = section.quantity(constant.key, quantity);
            allowed += (allowed.empty() ? "" : ", ") + constant.key;
          }
      for (const exact::ExactKind &other : kinds)
        for (const exact::ExactConstant &constant : other.constants)
          if (section.given(constant.key) && !values.count(constant.key))
            section.reject(constant.key, !kind ? "no exact solution is named; set Exact solution/Name"
                                               : "belongs to '" + other.name + "', not to '" + kind->name +
                                                     "'; that has " + (allowed.empty() ? "no constants" : allowed));
      return values;
    }

    /// Time at which the chain of stages ends, 0 if it is not known beforehand.
    double
    run_duration(const std::vector<Stage> &stages)
    {
      double duration = 0;
      for (const Stage &stage : stages)
        if (!stage.end->is_known())
          return 0;
        else
          duration = stage.end->expected({duration, 0., 0.});
      return duration;
    }

    template <int dim>
    exact::BodyState<dim>
    body_state(const Problem<dim> &problem, const Body<dim> &body)
    {
      const Scene<dim>     &scene = problem.scene;
      exact::BodyState<dim> state;
      state.name      = body.name;
      state.material  = problem.materials[body.material].model;
      state.constants = scene.materials[body.material].request;
      Box<dim> box    = extent(body.shape);
      for (int d = 0; d < dim; ++d)
        {
          box.lower[d] = std::isfinite(box.lower[d]) ? box.lower[d] : scene.lattice.origin[d];
          box.upper[d] = std::isfinite(box.upper[d]) ? box.upper[d] : scene.upper_corner()[d];
        }
      box         = scene.mapped_box(box);
      state.lower = box.lower;
      state.upper = box.upper;
      state.round = body.shape.template as<Sphere<dim>>() != nullptr;
      if (!state.round && !body.shape->is_box())
        state.inside = [shape = body.shape](const Vector<dim> &x) { return shape->contains(x); };
      state.velocity = body.velocity;
      state.density  = body.density;
      state.energy   = body.energy;
      state.deposit  = body.deposit ? body.deposit->energy : 0.;
      return state;
    }
  } // namespace

  void
  declare_exact_solution(SceneParameters &parameters)
  {
    SceneSection section(parameters, path);
    section.declare("Name", "none", "none | what the run is measured against: whipple help 'exact solutions'");
    section.declare("Geometry", "planar",
                    "of a profile: planar (along axis 1) | cylindrical | spherical (distance from the origin)");
    section.declare("Start time", "0 us", "time of the solution at the start of the run");
    std::vector<std::string> declared;
    for (const exact::ExactKind &kind : exact::exact_kinds<2>())
      for (const exact::ExactConstant &constant : kind.constants)
        if (std::find(declared.begin(), declared.end(), constant.key) == declared.end())
          {
            section.declare(constant.key, "", constant.documentation);
            declared.push_back(constant.key);
          }
  }

  template <int dim>
  void
  read_exact_solution(SceneParameters &parameters, Problem<dim> &problem)
  {
    const Scene<dim>                   &scene = problem.scene;
    const SceneSection                  section(parameters, path);
    const std::vector<exact::ExactKind> kinds = exact::exact_kinds<dim>();
    std::vector<std::string>            names{"none"};
    for (const exact::ExactKind &kind : kinds)
      names.push_back(kind.name);
    const std::size_t       index = section.name_index("Name", section.text("Name"), names);
    const exact::ExactKind *kind  = index > 0 ? &kinds[index - 1] : nullptr;

    exact::ExactRequest<dim> request;
    request.name      = names[index];
    request.geometry  = section.choice<exact::Geometry>("Geometry", geometries);
    request.start     = section.quantity("Start time", units::time);
    request.constants = read_constants(section, kinds, kind);
    if (!kind)
      return;
    request.duration      = run_duration(scene.stages);
    request.symmetry      = scene.lattice.symmetry;
    const Box<dim> domain = scene.mapped_box({scene.lattice.origin, scene.upper_corner()});
    request.lower         = domain.lower;
    request.upper         = domain.upper;
    request.boundaries    = scene.boundaries;
    for (const Body<dim> &body : scene.bodies)
      {
        request.bodies.push_back(body_state(problem, body));
        if (request.bodies.back().inside && !kind->any_shape)
          section.reject("Name", "takes bodies as boxes; body '" + body.name +
                                     "' is neither box nor plate nor sphere, or turned; allowed are those");
      }
    try
      {
        problem.exact = exact::make_exact_solution<dim>(request);
      }
    catch (const InputError &error)
      {
        section.reject("Name", error.what());
      }
  }

  template <int dim>
  void
  check_initial_states(SceneParameters &parameters, const Problem<dim> &problem)
  {
    for (const Body<dim> &body : problem.scene.bodies)
      if (body.initial_state == InitialState::exact && !problem.exact)
        SceneSection(parameters, "Bodies/" + body.name)
            .reject("Initial state", "the scene names no exact solution; set Exact solution/Name");
  }

  template <int dim>
  void
  drive_sides(SceneParameters &parameters, Problem<dim> &problem)
  {
    Scene<dim> &scene = problem.scene;
    for (int side = 0; side < 2 * dim; ++side)
      {
        if (scene.boundaries[side].kind != BoundaryKind::exact)
          continue;
        if (!problem.exact)
          SceneSection(parameters, "Geometry")
              .reject(side_names[side], "the scene names no exact solution; set Exact solution/Name");
        scene.boundaries[side].motion = [solution = problem.exact](const Vector<dim> &x, double time) {
          const Vector<dim> velocity = solution->at(x, time).velocity;
          for (const double component : velocity)
            if (std::isnan(component))
              {
                std::ostringstream text;
                text << "the exact solution '" << solution->name() << "' gives no velocity at (" << x[0] << ", " << x[1]
                     << ") cm, " << time << " us, for a side that follows it";
                throw StateError(text.str());
              }
          return velocity;
        };
      }
  }

  template void
  drive_sides(SceneParameters &, Problem<2> &);
  template void
  read_exact_solution(SceneParameters &, Problem<2> &);
  template void
  check_initial_states(SceneParameters &, const Problem<2> &);
} // namespace whipple::sections
