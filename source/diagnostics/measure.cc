// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/measure.h>

namespace whipple
{
  template <int dim>
  std::map<std::string, ResultTable>
  expected_results(const Problem<dim> &problem)
  {
    std::map<std::string, ResultTable> results;
    for (const auto &[key, entry] : MeasureRegistry<dim>::all())
      if (entry.measure)
        entry.measure->expect(problem, results);
    return results;
  }

  template std::map<std::string, ResultTable>
  expected_results(const Problem<2> &);
} // namespace whipple
