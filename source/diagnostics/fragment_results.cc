// SPDX-License-Identifier: LGPL-2.1-or-later
// Fragments at the end of every stage of a scene with the effect "fragment size"; null where nothing has broken.
#include <whipple/diagnostics/phase_measure.h>
#include <whipple/diagnostics/stage_table.h>

namespace whipple
{
  namespace
  {
    ResultTable
    fragment_results(std::optional<double> mean_size)
    {
      return {{"mean_fragment_size_cm", mean_size ? summary::Result(*mean_size) : summary::Result()}};
    }

    const MeasureRegistration<2> registration(30, "fragments",
                                              std::make_shared<StageTable<2>>(
                                                  "fragment size",
                                                  [](const MeasureView<2> &view) {
                                                    return fragment_results(mean_fragment_size(
                                                        view.layout, view.mesh, view.state, view.communicator));
                                                  },
                                                  fragment_results(0.)));
  } // namespace
} // namespace whipple
