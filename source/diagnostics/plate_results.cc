// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes and craters of the plates at the end of every Eulerian stage.
#include <whipple/diagnostics/measure.h>
#include <whipple/diagnostics/plate_measure.h>

#include <optional>
#include <variant>

namespace whipple
{
  namespace
  {
    /// Measured at `time` (us); all but that null if the plate could not be measured.
    ResultTable
    plate_results(const std::optional<PlateMeasure> &measure, double time)
    {
      const PlateMeasure m = measure.value_or(PlateMeasure{});
      ResultTable        results{
          {"perforated", m.perforated},          {"perforation_margin_cm", m.perforation_margin},
          {"hole_diameter_cm", m.hole_diameter}, {"smallest_hole_diameter_cm", m.smallest_hole_diameter},
          {"crater_depth_cm", m.crater_depth},   {"rear_bulge_cm", m.rear_bulge},
          {"front_lip_cm", m.front_lip},         {"least_thickness_cm", m.least_thickness},
          {"detached_mass_g", m.detached_mass}};
      if (!measure)
        for (auto &[quantity, value] : results)
          value = std::monostate{};
      results["measured_at_us"] = time;
      return results;
    }

    template <int dim>
    class Plates : public Measure<dim>
    {
    public:
      void
      stage_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        for (const std::size_t plate : measured_plates(view.scene, view.stage))
          {
            const std::string &name = view.scene.bodies[plate].name;
            const auto         measure =
                measure_plate(view.scene, view.layout, plate, view.mesh, view.state, view.communicator);
            if (!measure)
              report.warn("stage " + view.scene.stages[view.stage].name + ": plate " + name +
                          " cannot be measured: it is thinner than a cell, or nothing of it is left");
            for (const auto &[quantity, value] : plate_results(measure, view.state.time))
              report.results[name][quantity] = value;
          }
      }

      void
      plates_have_settled(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        stage_ends(view, report);
      }

      /// What the run has not come to, because nothing flew on to it, is whole.
      void
      run_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        for (std::size_t s = 0; s < view.scene.stages.size(); ++s)
          for (const std::size_t plate : measured_plates(view.scene, s))
            if (const Body<dim> &body = view.scene.bodies[plate]; !report.results.contains(body.name))
              {
                const Box<dim> box = extent(body.shape);
                PlateMeasure   whole;
                whole.least_thickness     = box.upper[dim - 1] - box.lower[dim - 1];
                whole.perforation_margin  = -whole.least_thickness;
                report.results[body.name] = plate_results(whole, view.state.time);
              }
      }

      void
      expect(const Problem<dim> &problem, std::map<std::string, ResultTable> &results) const override
      {
        const Scene<dim> &scene = problem.scene;
        for (std::size_t s = 0; s < scene.stages.size(); ++s)
          for (const std::size_t plate : measured_plates(scene, s))
            results[scene.bodies[plate].name].merge(plate_results(PlateMeasure{}, 0.));
      }
    };

    const MeasureRegistration<2> registration(40, "plates", std::make_shared<Plates<2>>());
  } // namespace
} // namespace whipple
