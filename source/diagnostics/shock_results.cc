// SPDX-License-Identifier: LGPL-2.1-or-later
// The shock of the scene's exact solution at the end of the run.
#include <whipple/diagnostics/measure.h>
#include <whipple/diagnostics/shock_measure.h>

namespace whipple
{
  namespace
  {
    ResultTable
    shock_results(const ShockMeasure &measure)
    {
      ResultTable results{
          {"shock_position_exact_cm", measure.exact}, {"shock_position_cm", {}}, {"shock_spread_cm", {}}};
      if (measure.mean)
        results["shock_position_cm"] = *measure.mean;
      if (measure.spread)
        results["shock_spread_cm"] = *measure.spread;
      return results;
    }

    template <int dim>
    class Shock : public Measure<dim>
    {
    public:
      void
      run_ends(const MeasureView<dim> &view, MeasureReport &report) const override
      {
        if (!view.problem.exact)
          return;
        if (const auto shock = measure_shock<dim>(view.problem, view.mesh, view.state, view.communicator))
          report.results[exact_place] = shock_results(*shock);
      }

      void
      expect(const Problem<dim> &problem, std::map<std::string, ResultTable> &results) const override
      {
        if (problem.exact && problem.exact->shock_position(0.))
          results[exact_place] = shock_results({});
      }
    };

    const MeasureRegistration<2> registration(60, "shock of the exact solution", std::make_shared<Shock<2>>());
  } // namespace
} // namespace whipple
