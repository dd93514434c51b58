// SPDX-License-Identifier: LGPL-2.1-or-later
// Fragments at the end of every stage of a scene with the effect "fragment size"; null where nothing has broken.
#include <whipple/diagnostics/fragment_sizes.h>
#include <whipple/diagnostics/stage_table.h>

namespace whipple
{
  namespace
  {
    ResultTable
    fragment_results(const std::optional<FragmentSizes> &sizes)
    {
      const FragmentSizes s = sizes.value_or(FragmentSizes{});
      ResultTable         results{{"mean_fragment_size_cm", s.mean_size}, {"fragment_number", s.number},
                          {"unbroken_mass_g", s.unbroken_mass},   {"fragment_size_edges_cm", s.edges},
                          {"mass_by_fragment_size_g", s.mass},    {"number_by_fragment_size", s.number_of_bin}};
      if (!sizes)
        for (auto &[quantity, value] : results)
          value = std::monostate{};
      return results;
    }

    const MeasureRegistration<2> registration(30, "fragments",
                                              std::make_shared<StageTable<2>>(
                                                  "fragment size",
                                                  [](const MeasureView<2> &view) {
                                                    return fragment_results(
                                                        measure_fragments(view.layout, view.mesh, view.state,
                                                                          view.communicator, view.waiting));
                                                  },
                                                  fragment_results(FragmentSizes{})));
  } // namespace
} // namespace whipple
