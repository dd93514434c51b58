// SPDX-License-Identifier: LGPL-2.1-or-later
// Temperature and phases at the end of every stage of a scene with the effect "melting".
#include <whipple/diagnostics/measure.h>
#include <whipple/diagnostics/phase_measure.h>

namespace whipple
{
  namespace
  {
    ResultTable
    phase_results(const PhaseMeasure &measure)
    {
      return {{"melt_share", measure.melt_share},
              {"vapour_share", measure.vapour_share},
              {"mean_temperature_K", measure.mean_temperature},
              {"temperature_99_K", measure.temperature_99}};
    }

    template <int dim>
    class Phases : public Measure<dim>
    {
    public:
      void
      stage_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        if (view.scene.has_effect("melting"))
          report.results[view.scene.stages[view.stage].name].merge(
              phase_results(measure_phases(view.layout, view.mesh, view.state, view.communicator)));
      }

      void
      expect(const Problem<dim> &problem, std::map<std::string, ResultTable> &results) const override
      {
        if (problem.scene.has_effect("melting"))
          for (const Stage &stage : problem.scene.stages)
            results[stage.name].merge(phase_results({}));
      }
    };

    const MeasureRegistration<2> registration(20, "phases", std::make_shared<Phases<2>>());
  } // namespace
} // namespace whipple
