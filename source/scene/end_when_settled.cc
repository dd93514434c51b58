// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/stage_end.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// When nothing that is watched has changed by more than a share of its largest value within a time, and next to
    /// no debris is still on its way.
    ///
    /// Looks are made at equal distances, `looks` of them in that time. The memory holds the time of the next look, the
    /// number of values, the largest value of each so far, and the last `looks` + 1 rows of values.
    class EndWhenSettled : public StageEnd
    {
    public:
      EndWhenSettled(double share, double time)
        : share_(share)
        , time_(time)
      {
      }
      double
      expected(const StageOutlook &outlook) const override
      {
        return outlook.start + time_; // at least
      }
      Left
      time_left(const StageView &stage, std::vector<double> &memory) const override
      {
        const double interval = time_ / looks;
        if (memory.empty())
          memory = {stage.start()};
        // steps end at looks: they do not depend on where the steps would have ended
        if (stage.time() < memory[0] - 1e-9 * interval)
          return {memory[0] - stage.time(), std::max(stage.start(), stage.time()) + time_};
        memory[0] += interval;
        if (remember(stage, memory) && has_come(stage))
          return {0., stage.time()};
        return {memory[0] - stage.time(), std::max(stage.start(), stage.time()) + time_};
      }

    private:
      static constexpr int looks = 10;

      /// Whether next to no debris is still on its way.
      static bool
      has_come(const StageView &stage)
      {
        const double all = stage.beyond(-std::numeric_limits<double>::infinity(), 0.).momentum;
        return stage.coming(0.) <= share_still_coming * all;
      }

      /// Add a row. @returns whether all rows of a whole time agree
      bool
      remember(const StageView &stage, std::vector<double> &memory) const
      {
        std::vector<double> row;
        for (const auto &[name, value] : stage.watched())
          row.push_back(value);
        const std::size_t n = row.size();
        if (memory.size() == 1 || memory[1] != static_cast<double>(n)) // first look, or there is other to watch
          {
            memory.resize(1);
            memory.push_back(static_cast<double>(n));
            memory.insert(memory.end(), n, 0.);
          }
        for (std::size_t i = 0; i < n; ++i)
          memory[2 + i] = std::max(memory[2 + i], std::abs(row[i]));
        const std::size_t first = 2 + n;
        memory.insert(memory.end(), row.begin(), row.end());
        if (memory.size() > first + (looks + 1) * n)
          memory.erase(memory.begin() + first, memory.begin() + first + n);
        if (memory.size() < first + (looks + 1) * n)
          return false;
        for (std::size_t i = 0; i < n; ++i)
          {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (std::size_t k = first + i; k < memory.size(); k += n)
              {
                low  = std::min(low, memory[k]);
                high = std::max(high, memory[k]);
              }
            if (high - low > share_ * memory[2 + i])
              return false;
          }
        return true;
      }

      double share_; ///< of the largest value so far
      double time_;  ///< us
    };

    const StageEndRegistration registration(
        "until settled",
        {"'until settled within 1 % for 2 us'",
         "when kinetic energies, holes and craters have changed by no more than that share of their largest value for "
         "that long",
         [](const StageEndInput &input) -> std::shared_ptr<const StageEnd> {
           constexpr const char *within = "within ", *during = " for ";
           const std::size_t     split = input.rest.find(during);
           if (!input.rest.starts_with(within) || split == std::string::npos)
             input.reject("allowed is 'until settled within 1 % for 2 us'");
           const std::string share_text =
               input.rest.substr(std::string(within).size(), split - std::string(within).size());
           const double share = input.value(share_text, units::number);
           const double time  = input.value(input.rest.substr(split + std::string(during).size()), units::time);
           if (!(share > 0 && share <= 1 && time > 0))
             input.reject("allowed are a share from 0 to 100 % and a time > 0 us");
           return std::make_shared<EndWhenSettled>(share, time);
         }});
  } // namespace
} // namespace whipple
