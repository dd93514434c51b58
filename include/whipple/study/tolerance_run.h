// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/cost_law.h>
#include <whipple/study/tolerance.h>

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace whipple
{
  /// What a run on some cells is expected to bring and to take.
  struct CellForecast
  {
    std::size_t point    = 0; ///< index into StudyPlan::points
    double      cell     = 0; ///< cm
    double      error    = 0; ///< as the tolerance: a part of the value, or in its unit
    double      seconds  = 0;
    bool        computed = false; ///< it is one of the coarse runs that this is learnt from
  };

  /// A method (values of the axes other than the cell axis) with what its coarse runs let expect.
  struct MethodForecast
  {
    std::string               label;
    std::string               excluded; ///< why nothing can be expected of it, else empty
    convergence::PowerLaw     error;    ///< C h^p; error bars where there is no exact solution
    CostLaw                   cost;
    std::string               verdict; ///< of the coarse runs
    std::vector<CellForecast> rows;    ///< coarse to fine, all that could be chosen
  };

  /// Forecast and truth.
  struct ToleranceVerdict
  {
    Tolerance                   tolerance;
    std::optional<double>       budget_s; ///< seconds for all that this command runs
    std::vector<MethodForecast> methods;
    std::optional<std::size_t>  method;      ///< that was run; none if there was nothing to run
    CellForecast                chosen;      ///< the cheapest setting that reaches the tolerance, if one does
    std::optional<double>       final_error; ///< judged with the chosen run, as the tolerance; none if it did not run
    double                      final_seconds = 0;     ///< wall time of the chosen run
    bool                        reached       = false; ///< by a run that is there
    std::string                 conclusion;            ///< in words, one or more lines
  };

  struct ToleranceOutcome
  {
    std::vector<PointOutcome> outcomes; ///< of all points that have run, coarse to fine
    ToleranceVerdict          verdict;
  };

  /// Run the three coarsest levels of each method, fit error and cost, print what finer cells promise, and run the
  /// cheapest setting that reaches the tolerance if it fits what is left of the budget.
  /// @param plan of with_cell_ladder
  ToleranceOutcome
  run_to_tolerance(const StudyPlan &plan, const Tolerance &tolerance, std::optional<double> budget_s,
                   StudyRunner &runner, std::ostream &output);

  /// The forecast of one method as a table of Markdown: cell size, expected error, expected time; until just below the
  /// tolerance.
  std::string
  forecast_table(const MethodForecast &method, const Tolerance &tolerance);

  /// What some levels of a method say about its error.
  struct ErrorNow
  {
    std::string           reason{};              ///< why nothing can be said, else empty
    double                error             = 0; ///< of the finest level, as the tolerance
    double                limit             = 0; ///< what the values tend to: 0 for errors of an exact solution
    double                limit_uncertainty = 0; ///< what that may be wrong by
    double                scale             = 1; ///< what absolute errors were divided by
    convergence::PowerLaw law{};                 ///< C h^p of further levels
    std::string           verdict{};             ///< "monotone, order 1.1"
  };

  /// @param levels coarse to fine
  ErrorNow
  error_now(const std::vector<PointOutcome> &levels, const Tolerance &tolerance);

  /// Fit error and cost of the coarse runs of a method and forecast all its points. Pure function of its arguments.
  MethodForecast
  forecast_method(const StudyPlan &plan, const std::vector<PointOutcome> &coarse, const Tolerance &tolerance,
                  const std::string &label);

  /// An error in the terms of a tolerance, "1.8 %" or "0.012 cm".
  std::string
  show_error(const Tolerance &tolerance, double error);
} // namespace whipple
