// SPDX-License-Identifier: LGPL-2.1-or-later
// The debris cloud of every Lagrangian stage, when it takes over and when it ends.
#include <whipple/diagnostics/debris_measure.h>
#include <whipple/diagnostics/measure.h>
#include <whipple/effect/scene_outlook.h>
#include <whipple/ledger/ledger.h>
#include <whipple/ledger/totals.h>

#include <optional>

namespace whipple
{
  namespace
  {
    /// Prefix of what is measured when a stage begins.
    constexpr const char *handover_prefix = "handover_";

    ResultTable
    debris_results(const DebrisMeasure &measure, std::optional<double> inline_velocity, double time,
                   const std::string &prefix)
    {
      ResultTable results{{prefix + "mass_g", measure.mass},
                          {prefix + "axial_momentum_g_cm_per_us", measure.axial_momentum},
                          {prefix + "mass_velocity_cm_per_us", measure.mass_velocity},
                          {prefix + "leading_edge_cm", measure.leading_edge},
                          {prefix + "leading_edge_velocity_cm_per_us", measure.leading_edge_velocity},
                          {prefix + "length_cm", measure.length},
                          {prefix + "radius_cm", measure.radius},
                          {prefix + "radius_95_cm", measure.radius_95},
                          {prefix + "depth_95_cm", measure.depth_95},
                          {prefix + "cone_angle_deg", measure.cone_angle},
                          {prefix + "cone_half_angle_deg", 0.5 * measure.cone_angle},
                          {prefix + "time_us", time}};
      if (inline_velocity)
        results[prefix + "inline_mass_velocity_cm_per_us"] = *inline_velocity;
      return results;
    }

    /// Mean axial velocity of the material of the bodies that came flying, cm/us; none if it cannot be told apart.
    template <int dim>
    std::optional<double>
    projectile_velocity(const MeasureView<dim> &view)
    {
      if (!view.layout.bodies_separable)
        return std::nullopt;
      const auto bodies =
          body_totals(view.mesh, view.state, view.layout.body_tag, view.layout.body_material, view.communicator);
      double mass = 0, momentum = 0;
      for (std::size_t b = 0; b < bodies.size(); ++b)
        if (view.scene.bodies[b].velocity[Ledger<dim>::axial] != 0.)
          {
            mass += bodies[b].mass;
            momentum += bodies[b].momentum[Ledger<dim>::axial];
          }
      return mass > 0 ? std::optional<double>(momentum / mass) : std::nullopt;
    }

    template <int dim>
    class Cloud : public Measure<dim>
    {
    public:
      void
      stage_begins(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        measure(view, handover_prefix, report);
      }
      void
      stage_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        measure(view, "", report);
      }

      std::vector<std::string>
      lines(const Scene<dim> &scene, std::size_t stage,
            const std::map<std::string, ResultTable> &results) const override
      {
        const std::string &name  = scene.stages[stage].name;
        const auto         found = results.find(name);
        if (scene.stages[stage].mode() != StageMode::lagrangian || found == results.end())
          return {};
        const auto value = [&](const char *quantity) { return number_in(found->second, quantity).value_or(0.); };
        if (!(value("mass_g") > 0))
          return {name + ": nothing flies on"};
        constexpr double km_s = 10.; // cm/us
        return {name + ": " + rounded(value("mass_g")) + " g at " + rounded(km_s * value("mass_velocity_cm_per_us")) +
                " km/s, front at " + rounded(value("leading_edge_cm")) + " cm with " +
                rounded(km_s * value("leading_edge_velocity_cm_per_us")) + " km/s, cone " +
                rounded(value("cone_angle_deg")) + " degrees, 95 % within " + rounded(value("depth_95_cm")) +
                " cm behind the plate, at " + rounded(value("time_us")) + " us"};
      }

      void
      expect(const Problem<dim> &problem, std::map<std::string, ResultTable> &results) const override
      {
        const std::optional<double> inline_velocity =
            problem.layout.bodies_separable ? std::optional<double>(0.) : std::nullopt;
        for (const Stage &stage : problem.scene.stages)
          if (stage.mode() == StageMode::lagrangian)
            for (const char *prefix : {handover_prefix, ""})
              results[stage.name].merge(debris_results({}, inline_velocity, 0., prefix));
      }

    private:
      static void
      measure(const MeasureView<dim> &view, const std::string &prefix, MeasureReport &report)
      {
        const Stage &stage = view.scene.stages[view.stage];
        if (stage.mode() != StageMode::lagrangian)
          return;
        const double origin =
            stage.lagrangian->debris.behind
                ? extent(view.scene.bodies[*stage.lagrangian->debris.behind].shape).upper[flight_axis<dim>]
                : 0.;
        const DebrisMeasure m = measure_debris<dim>(
            view.mesh, view.state, [](Index) { return true; }, origin, view.communicator, view.waiting);
        report.results[stage.name].merge(debris_results(m, projectile_velocity(view), view.state.time, prefix));
      }
    };

    const MeasureRegistration<2> registration(10, "debris cloud", std::make_shared<Cloud<2>>());
  } // namespace
} // namespace whipple
