// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/measure.h>

#include <functional>
#include <string>

namespace whipple
{
  /// Results at the end of every stage, under its name, of scenes in which an effect is on.
  template <int dim>
  class StageTable : public Measure<dim>
  {
  public:
    using Look = std::function<ResultTable(const MeasureView<dim> &view)>;

    /// @param look     collective
    /// @param expected what it finds, for names and types
    StageTable(const std::string &effect, Look look, const ResultTable &expected)
      : effect_(effect)
      , look_(std::move(look))
      , expected_(expected)
    {
    }

    void
    stage_ends(const MeasureView<dim> &view, MeasureReport &report) const override
    {
      if (view.scene.has_effect(effect_))
        report.results[view.scene.stages[view.stage].name].merge(look_(view));
    }

    void
    expect(const Problem<dim> &problem, std::map<std::string, ResultTable> &results) const override
    {
      if (problem.scene.has_effect(effect_))
        for (const Stage &stage : problem.scene.stages)
          {
            ResultTable expected = expected_;
            results[stage.name].merge(expected);
          }
    }

  private:
    std::string effect_;
    Look        look_;
    ResultTable expected_;
  };
} // namespace whipple
