// SPDX-License-Identifier: LGPL-2.1-or-later
// Temperature and phases at the end of every stage of a scene with the effect "melting".
#include <whipple/diagnostics/phase_measure.h>
#include <whipple/diagnostics/stage_table.h>

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

    const MeasureRegistration<2> registration(20, "phases",
                                              std::make_shared<StageTable<2>>(
                                                  "melting",
                                                  [](const MeasureView<2> &view) {
                                                    return phase_results(measure_phases(view.layout, view.mesh,
                                                                                        view.state, view.communicator));
                                                  },
                                                  phase_results({})));
  } // namespace
} // namespace whipple
