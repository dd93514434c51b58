// SPDX-License-Identifier: LGPL-2.1-or-later
// Holes and craters of the plates at the end of every Eulerian stage.
#include <whipple/diagnostics/measure.h>
#include <whipple/diagnostics/plate_measure.h>
#include <whipple/effect/scene_outlook.h>

#include <optional>
#include <set>
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

    /// Holes and craters in one line.
    std::string
    in_words(const std::string &plate, const ResultTable &table)
    {
      const auto length = [&](const char *quantity) {
        return rounded(number_in(table, quantity).value_or(0.)) + " cm";
      };
      const bool *perforated = std::get_if<bool>(&table.at("perforated"));
      std::string text       = plate + ": ";
      if (!perforated)
        return text + "could not be measured (thinner than a cell, or nothing of it is left)";
      if (*perforated)
        text += "perforated, hole " + length("hole_diameter_cm") +
                " (clear for a straight flight: " + length("smallest_hole_diameter_cm") + ")";
      else
        text += "holds, crater " + length("crater_depth_cm") + ", rear bulge " + length("rear_bulge_cm") +
                ", least thickness " + length("least_thickness_cm");
      if (number_in(table, "detached_mass_g").value_or(0.) > 0)
        text += ", detached " + rounded(*number_in(table, "detached_mass_g")) + " g";
      return text + ", at " + rounded(number_in(table, "measured_at_us").value_or(0.)) + " us";
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

      std::vector<std::string>
      lines(const Scene<dim> &scene, std::size_t stage,
            const std::map<std::string, ResultTable> &results) const override
      {
        std::set<std::size_t> again; // told of later
        for (std::size_t later = stage + 1; later < scene.stages.size(); ++later)
          for (const std::size_t plate : measured_plates(scene, later))
            again.insert(plate);
        std::vector<std::string> told;
        for (const std::size_t plate : measured_plates(scene, stage))
          if (const auto found = results.find(scene.bodies[plate].name);
              !again.contains(plate) && found != results.end())
            told.push_back(in_words(found->first, found->second));
        return told;
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
