// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/stage_end.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// When holes and craters have stopped growing.
    ///
    /// Looks are made at times t_n = growth^n t_0 after the start, t_0 the first step. The end is there when over the
    /// last `looks` looks (the last third of the time) none has changed by more than `share` of its largest value, nor
    /// by more than half a finest cell (if that is below `small` of it), whichever is more, and there is one. The
    /// memory holds the time of the next look, the number of values, and the last rows of values.
    class EndWhenHolesSettle : public StageEnd
    {
    public:
      explicit EndWhenHolesSettle(double latest)
        : latest_(latest)
      {
      }
      double
      expected(const StageOutlook &outlook) const override
      {
        return outlook.start; // at least
      }
      bool
      is_known() const override
      {
        return false;
      }
      Left
      time_left(const StageView &stage, std::vector<double> &memory) const override
      {
        const double past = stage.time() - stage.start();
        if (memory.empty())
          {
            if (!(past > 0))
              return {std::numeric_limits<double>::infinity(), stage.time()};
            memory = {past, 0.};
          }
        if (past >= latest_ * (1. - 1e-9))
          return {0., stage.time()};
        if (past >= memory[0] * (1. - 1e-9))
          {
            memory[0] = past * growth;
            if (remember(stage, memory))
              return {0., stage.time()};
          }
        const double next = std::min(memory[0], latest_);
        return {next - past, stage.start() + next};
      }

    private:
      static constexpr double      growth = 1.1, share = 0.02, cells = 0.5, small = 0.1;
      static constexpr std::size_t looks = 5; // 1.1^4 = 1.46

      /// Add a row. @returns whether the last rows agree, and there is something
      static bool
      remember(const StageView &stage, std::vector<double> &memory)
      {
        std::vector<double> row;
        for (const auto &[name, value] : stage.watched())
          if (name.starts_with("hole of ") || name.starts_with("crater of "))
            row.push_back(value);
        const std::size_t n = row.size(), first = 2;
        if (memory[1] != static_cast<double>(n))
          memory.resize(first);
        memory[1] = static_cast<double>(n);
        memory.insert(memory.end(), row.begin(), row.end());
        if (memory.size() > first + looks * n)
          memory.erase(memory.begin() + first, memory.begin() + first + n);
        if (memory.size() < first + looks * n || std::all_of(row.begin(), row.end(), [](double v) { return !(v > 0); }))
          return false;
        for (std::size_t i = 0; i < n; ++i)
          {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (std::size_t k = first + i; k < memory.size(); k += n)
              {
                low  = std::min(low, memory[k]);
                high = std::max(high, memory[k]);
              }
            if (high - low > std::max(share * high, std::min(cells * stage.finest_cell(), small * high)))
              return false;
          }
        return true;
      }

      double latest_; ///< us since the start
    };

    const StageEndRegistration registration(
        "until holes have settled",
        {"'until holes have settled', '... within 10 us'",
         "when in the last third of the time no hole or crater has grown by more than 2 %; at the latest after that "
         "time",
         [](const StageEndInput &input) -> std::shared_ptr<const StageEnd> {
           const std::string within = "within ";
           if (input.rest.empty())
             return std::make_shared<EndWhenHolesSettle>(std::numeric_limits<double>::infinity());
           if (!input.rest.starts_with(within))
             input.reject("allowed is 'until holes have settled' or 'until holes have settled within 10 us'");
           const double latest = input.value(input.rest.substr(within.size()), units::time);
           if (!(latest > 0))
             input.reject("allowed is a time > 0 us");
           return std::make_shared<EndWhenHolesSettle>(latest);
         }});
  } // namespace
} // namespace whipple
