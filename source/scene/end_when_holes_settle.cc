// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/stage_end.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace whipple
{
  namespace
  {
    /// When holes and craters have stopped growing.
    ///
    /// Looks are made at times t_n = growth^n t_0 after the start, t_0 the first step. The end is there when over the
    /// last `looks` looks (the last third of the time) none has changed by more than `share` of its largest value, nor
    /// by more than half a finest cell (if that is below `small` of it; of a crater, of the dent it lies in), whichever
    /// is more. The dent itself may go on where it is slow: a wall whose rim is free moves on as a whole. As long as
    /// there is no hole and no crater, kinetic energies are looked at instead: what meets a plate loses some. The
    /// memory holds the time of the next look, the number of values, and the last rows of values.
    class EndWhenHolesSettle : public StageEnd
    {
    public:
      /// What is before a plane across axis 1 [cm] and faster along it than `velocity` [cm/us] is on its way to it.
      struct Target
      {
        double plane, velocity;
      };

      /// @param slow velocity below which a dent may go on, cm/us
      EndWhenHolesSettle(double latest, double slow, std::optional<Target> target)
        : latest_(latest)
        , slow_(slow)
        , target_(target)
      {
      }
      double
      expected(const StageOutlook &outlook) const override
      {
        return outlook.start; // at least
      }
      Left
      time_left(const StageView &stage, std::vector<double> &memory) const override
      {
        const double past = stage.time() - stage.start();
        if (memory.empty())
          {
            if (!(past > 0))
              return {std::numeric_limits<double>::infinity(), stage.time()};
            memory = {past, 0., on_its_way(stage)};
          }
        if (past >= latest_ * (1. - 1e-9))
          return {0., stage.time()};
        if (past >= memory[0] * (1. - 1e-9))
          {
            memory[0]          = past * growth;
            const bool settled = remember(stage, past, memory);
            if (settled && on_its_way(stage) <= late * memory[2])
              return {0., stage.time()};
          }
        const double next = std::min(memory[0], latest_);
        return {next - past, stage.start() + next};
      }

    private:
      static constexpr double      growth = 1.1, share = 0.02, cells = 0.5, small = 0.1, late = 0.02;
      static constexpr std::size_t looks = 5;
      static constexpr double window = growth * growth * growth * growth; // 1.46: from the first of these to the last

      static inline const std::string crater = "crater of ", dent = "dent of ";

      /// Kinetic energy, Mbar cm^3: what a crater's volume goes by.
      double
      on_its_way(const StageView &stage) const
      {
        if (!target_)
          return 0.;
        const double everywhere = -std::numeric_limits<double>::infinity();
        return stage.beyond(everywhere, target_->velocity).kinetic_energy -
               stage.beyond(target_->plane, target_->velocity).kinetic_energy;
      }

      static bool
      is_of_plate(const std::string &name)
      {
        return name.starts_with("hole of ") || name.starts_with(crater) || name.starts_with(dent);
      }

      /// Add a row. @returns whether the last rows agree
      bool
      remember(const StageView &stage, double past, std::vector<double> &memory) const
      {
        constexpr std::size_t               first   = 3;
        const std::map<std::string, double> watched = stage.watched();
        const std::size_t                   n       = watched.size();
        if (memory[1] != static_cast<double>(n))
          memory.resize(first);
        memory[1] = static_cast<double>(n);
        for (const auto &[name, value] : watched)
          memory.push_back(value);
        if (memory.size() > first + looks * n)
          memory.erase(memory.begin() + first, memory.begin() + first + n);
        if (memory.size() < first + looks * n)
          return false;
        const bool  has_hole = std::any_of(watched.begin(), watched.end(), [](const auto &entry) {
          return is_of_plate(entry.first) && entry.second > 0;
        });
        std::size_t i        = first;
        for (const auto &[name, value] : watched)
          if (const std::size_t column = i++; is_of_plate(name) == has_hole)
            {
              double low = std::numeric_limits<double>::infinity(), high = -low;
              for (std::size_t k = column; k < memory.size(); k += n)
                {
                  low  = std::min(low, memory[k]);
                  high = std::max(high, memory[k]);
                }
              const double size  = name.starts_with(crater) ? watched.at(dent + name.substr(crater.size())) : high;
              const double slack = has_hole ? std::min(cells * stage.finest_cell(), small * size) : 0.;
              const bool   slow  = name.starts_with(dent) && high - low <= slow_ * (past - past / window);
              if (high - low > std::max(share * high, slack) && !slow)
                return false;
            }
        return true;
      }

      double                latest_; ///< us since the start
      double                slow_;   ///< cm/us
      std::optional<Target> target_;
    };

    /// Part of the largest speed of a body below which a dent may go on: far below what tears a plate.
    constexpr double slow_share = 0.01;

    const StageEndRegistration registration(
        "until holes have settled",
        {"'until holes have settled', '... and debris has reached BODY', '... within 10 us'",
         "when in the last third of the time no hole or crater has grown by more than 2 %, and all but 2 % of the "
         "debris, by its kinetic energy, has come to that body; at the latest after that time",
         [](const StageEndInput &input) -> std::shared_ptr<const StageEnd> {
           const std::string within = "within ", reached = "and debris has reached ";
           std::string       rest   = input.rest;
           double            latest = std::numeric_limits<double>::infinity();
           if (const std::size_t at = rest.rfind(within); at != std::string::npos && (at == 0 || rest[at - 1] == ' '))
             {
               latest = input.value(rest.substr(at + within.size()), units::time);
               rest.erase(at == 0 ? 0 : at - 1);
             }
           if (!(latest > 0))
             input.reject("allowed is a time > 0 us");
           const double slow = slow_share * input.largest_speed;
           if (rest.empty())
             return std::make_shared<EndWhenHolesSettle>(latest, slow, std::nullopt);
           if (!rest.starts_with(reached))
             input.reject(
                 "allowed is 'until holes have settled', followed by 'and debris has reached BODY', 'within 10 us', "
                 "or both");
           const std::size_t body = input.body(rest.substr(reached.size()));
           return std::make_shared<EndWhenHolesSettle>(
               latest, slow, EndWhenHolesSettle::Target{input.fronts[body], input.debris_velocity()});
         }});
  } // namespace

  std::shared_ptr<const StageEnd>
  until_holes_have_settled(double latest)
  {
    return std::make_shared<EndWhenHolesSettle>(latest, 0., std::nullopt);
  }
} // namespace whipple
