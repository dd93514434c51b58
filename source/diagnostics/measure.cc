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

  template <int dim>
  std::vector<std::string>
  result_lines(const Scene<dim> &scene, const std::map<std::string, ResultTable> &results)
  {
    std::vector<std::string> all;
    for (std::size_t stage = 0; stage < scene.stages.size(); ++stage)
      for (const auto &[key, entry] : MeasureRegistry<dim>::all())
        if (entry.measure)
          for (std::string &line : entry.measure->lines(scene, stage, results))
            all.push_back(std::move(line));
    return all;
  }

  template std::map<std::string, ResultTable>
  expected_results(const Problem<2> &);
  template std::vector<std::string>
  result_lines(const Scene<2> &, const std::map<std::string, ResultTable> &);
} // namespace whipple
