// SPDX-License-Identifier: LGPL-2.1-or-later
// Results against time, DIR/history.csv: what every measure would say if the stage ended now.
#include <whipple/diagnostics/measure.h>

#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

    /// A result that a table of numbers can hold; verdicts as 0 and 1.
    std::optional<double>
    as_number(const summary::Result &result)
    {
      if (const double *number = std::get_if<double>(&result))
        return *number;
      if (const bool *verdict = std::get_if<bool>(&result))
        return *verdict ? 1. : 0.;
      return std::nullopt;
    }

    /// Not of the present state, but of the moment when it was found or handed over.
    bool
    is_of_a_moment(const std::string &quantity)
    {
      return quantity.starts_with("handover_") || quantity == "time_us" || quantity == "measured_at_us";
    }

    template <int dim>
    class History : public Watch<dim>
    {
    public:
      explicit History(const Problem<dim> &problem)
        : interval_(*problem.scene.output.history_interval)
      {
        for (const auto &[place, table] : expected_results(problem))
          for (const auto &[quantity, result] : table)
            if (as_number(result) && !is_of_a_moment(quantity))
              columns_.push_back({place, quantity});
      }

      bool
      is_empty() const
      {
        return columns_.empty();
      }

      std::vector<WatchTable>
      tables() const override
      {
        WatchTable table{"history.csv", {"time_us", "stage"}};
        for (const auto &[place, quantity] : columns_)
          table.columns.push_back(place + ' ' + quantity);
        return {table};
      }

      void
      mesh_is_new(const MeasureView<dim> &, std::vector<double> &, const WriteRow &) const override
      {
      }

      void
      step_done(const MeasureView<dim> &view, double, std::vector<double> &memory, const WriteRow &write) const override
      {
        memory.resize(1, 0.); // us, when the next row is due
        const double time = view.state.time;
        if (time < memory[0])
          return;
        memory[0] = interval_ * (std::floor(time / interval_) + 1.);
        std::map<std::string, ResultTable> results;
        MeasureReport                      report{results, [](const std::string &) {}, [](const std::string &) {}};
        for (const auto &[key, entry] : MeasureRegistry<dim>::all())
          if (entry.measure)
            entry.measure->stage_ends(view, report);
        std::vector<double> row{time, static_cast<double>(view.stage + 1)};
        for (const auto &[place, quantity] : columns_)
          {
            const ResultTable &table = results[place]; // empty where the stage does not measure it
            const auto         found = table.find(quantity);
            row.push_back(found == table.end() ? no_value : as_number(found->second).value_or(no_value));
          }
        write(0, row);
      }

    private:
      double                                           interval_; ///< us
      std::vector<std::pair<std::string, std::string>> columns_;  ///< place, quantity
    };

    std::unique_ptr<const Watch<2>>
    watch(const Problem<2> &problem)
    {
      if (!problem.scene.output.history_interval)
        return nullptr;
      auto history = std::make_unique<History<2>>(problem);
      return history->is_empty() ? nullptr : std::move(history);
    }

    const MeasureRegistration<2> registration(90, "history", watch);
  } // namespace
} // namespace whipple
