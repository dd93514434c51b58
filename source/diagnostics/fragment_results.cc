// SPDX-License-Identifier: LGPL-2.1-or-later
// Fragments at the end of every stage of a scene with the effect "fragment size"; null where nothing has broken.
#include <whipple/diagnostics/measure.h>
#include <whipple/diagnostics/phase_measure.h>

namespace whipple
{
  namespace
  {
    ResultTable
    fragment_results(std::optional<double> mean_size)
    {
      return {{"mean_fragment_size_cm", mean_size ? summary::Result(*mean_size) : summary::Result()}};
    }

    template <int dim>
    class Fragments : public Measure<dim>
    {
    public:
      void
      stage_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        if (view.scene.has_effect("fragment size"))
          report.results[view.scene.stages[view.stage].name].merge(
              fragment_results(mean_fragment_size(view.layout, view.mesh, view.state, view.communicator)));
      }

      void
      expect(const Problem<dim> &problem, std::map<std::string, ResultTable> &results) const override
      {
        if (problem.scene.has_effect("fragment size"))
          for (const Stage &stage : problem.scene.stages)
            results[stage.name].merge(fragment_results(0.));
      }
    };

    const MeasureRegistration<2> registration(30, "fragments", std::make_shared<Fragments<2>>());
  } // namespace
} // namespace whipple
