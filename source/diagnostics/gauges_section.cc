// SPDX-License-Identifier: LGPL-2.1-or-later
// The section Gauges of a scene.
#include <whipple/diagnostics/gauge.h>
#include <whipple/diagnostics/phase_measure.h>
#include <whipple/problem/extra_section.h>
#include <whipple/scene/nearest_name.h>

#include <algorithm>

namespace whipple
{
  template <int dim>
  std::vector<CellField>
  gauge_fields(const FieldLayout &layout, const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
               const std::vector<Index> &cells)
  {
    const ExtraFields<dim> phases = [&](const State<dim> &s, const std::vector<Index> &c) {
      return phase_fields(layout, s, c);
    };
    std::vector<CellField> fields =
        fields_of_cells(mesh, state, derived, layout.material_names, phases, cells, /*rank=*/0);
    std::erase_if(fields, [](const CellField &field) { return field.name == "rank"; });
    return fields;
  }

  template <int dim>
  std::vector<CellField>
  known_gauge_fields(const FieldLayout &layout)
  {
    const FlatMesh<dim> mesh;
    Derived             derived;
    derived.material.resize(layout.materials.size());
    return gauge_fields<dim>(layout, mesh, layout.allocate(mesh), derived, {});
  }

  namespace
  {
    void
    declare(SceneSection &section)
    {
      section.declare("Kind", "fixed", "fixed | material | surface velocity");
      section.declare("Point", "", "fixed, material: where it is at the start");
      section.declare("Fields", "",
                      "fixed, material: names as in field files, and velocity; not given: density, "
                      "pressure, velocity");
      section.declare("Body", "", "surface velocity: one of Bodies/List");
      section.declare("Side", "", "surface velocity: rear | front, seen along axis 1; not given: rear");
      section.declare("Interval", "0 us", "time between rows; 0 us: every step");
    }

    template <int dim>
    void
    read_point(const SceneSection &section, const Scene<dim> &scene, Gauge<dim> &gauge)
    {
      gauge.point           = section.vector<dim>("Point", units::length);
      const Box<dim> domain = scene.mapped_box({scene.lattice.origin, scene.upper_corner()});
      for (int d = 0; d < dim; ++d)
        if (!(gauge.point[d] >= domain.lower[d] && gauge.point[d] <= domain.upper[d]))
          section.reject("Point", "outside the domain; allowed is along axis " + std::to_string(d) + " " +
                                      units::format(domain.lower[d], units::length) + " to " +
                                      units::format(domain.upper[d], units::length));
      for (const char *key : {"Body", "Side"})
        if (section.given(key))
          section.reject(key, "belongs to a gauge of kind surface velocity; allowed is nothing");
    }

    void
    read_fields(const SceneSection &section, const std::vector<std::string> &known, std::vector<std::string> &fields)
    {
      if (!section.given("Fields"))
        section.replace("Fields", "density, pressure, velocity");
      fields = section.list("Fields");
      for (std::size_t i = 0; i < fields.size(); ++i)
        {
          section.name_index("Fields", fields[i], known);
          if (std::find(fields.begin(), fields.begin() + i, fields[i]) != fields.begin() + i)
            section.reject("Fields", "'" + fields[i] + "' is listed twice; allowed is once");
        }
      if (fields.empty())
        section.reject("Fields", "must be given; " + name_choices("", known));
    }

    template <int dim>
    void
    read_surface(const SceneSection &section, const Scene<dim> &scene, const FieldLayout &layout, Gauge<dim> &gauge)
    {
      std::vector<std::string> bodies;
      for (const Body<dim> &body : scene.bodies)
        bodies.push_back(body.name);
      gauge.body = section.name_index("Body", section.text("Body"), bodies);
      if (!section.given("Side"))
        section.replace("Side", "rear");
      gauge.rear = section.choice<bool>("Side", {{"rear", true}, {"front", false}});
      for (const char *key : {"Point", "Fields"})
        if (section.given(key))
          section.reject(key, "belongs to a gauge of kind fixed or material; allowed is nothing");
      if (layout.bodies_separable)
        return;
      for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        if (b != gauge.body && scene.bodies[b].material == scene.bodies[gauge.body].material)
          section.reject("Body", "cannot be told from body '" + scene.bodies[b].name +
                                     "' of the same material; allowed is a body with a material of its own, or any "
                                     "with 'body tags' in Effects/List");
    }

    template <int dim>
    std::shared_ptr<const SectionContent>
    read(SceneParameters &parameters, const Problem<dim> &problem)
    {
      const Scene<dim>              &scene = problem.scene;
      const std::string              path  = Gauges<dim>::section;
      const std::vector<std::string> names = SceneSection(parameters, path).list("List");
      if (names.empty())
        return nullptr;
      const FieldLayout       &layout = problem.layout;
      std::vector<std::string> known{velocity_field};
      for (const CellField &field : known_gauge_fields<dim>(layout))
        known.push_back(field.name);

      auto gauges = std::make_shared<Gauges<dim>>();
      for (const std::string &name : names)
        {
          const SceneSection section(parameters, path + "/" + name);
          Gauge<dim>         gauge;
          gauge.name = name;
          gauge.kind = section.choice<GaugeKind>("Kind", {{"fixed", GaugeKind::fixed},
                                                          {"material", GaugeKind::material},
                                                          {"surface velocity", GaugeKind::surface_velocity}});
          if (gauge.kind == GaugeKind::surface_velocity)
            read_surface(section, scene, layout, gauge);
          else
            {
              read_point(section, scene, gauge);
              read_fields(section, known, gauge.fields);
            }
          gauge.interval = section.non_negative("Interval", units::time);
          gauges->list.push_back(gauge);
        }
      return gauges;
    }

    const ExtraSectionRegistration<2> registration(Gauges<2>::section, {"gauges", declare, read<2>});
  } // namespace

  template std::vector<CellField>
  gauge_fields(const FieldLayout &, const FlatMesh<2> &, const State<2> &, const Derived &, const std::vector<Index> &);
  template std::vector<CellField>
  known_gauge_fields<2>(const FieldLayout &);
} // namespace whipple
