// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/stage_end.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// When a plate has been perforated and gives no more momentum to, or takes it from, the debris behind it.
    ///
    /// Debris is what lies beyond the plate's rear face and is faster than a tenth of what came. Looks are made
    /// at times t_0 growth^n after the start, t_0 the first time at which there is debris. It is free once half of the
    /// momentum of what is that fast is beyond the plate, grows there by less than `share` between looks two apart (in
    /// the last sixth of the time), twice in a row, and next to nothing is still coming. At the latest, once that half
    /// is through, at `longest` times the time of it, or when the foremost has come to the next body.
    class EndWhenDebrisIsFree : public StageEnd
    {
    public:
      EndWhenDebrisIsFree(std::string name, double rear, double next_front, double velocity)
        : name_(std::move(name))
        , rear_(rear)
        , next_front_(next_front)
        , velocity_(velocity)
      {
      }
      double
      expected(const StageOutlook &outlook) const override
      {
        // the debris has left the plate by several of its own lengths
        constexpr double lengths = 3;
        if (!(outlook.fastest > 0))
          return std::numeric_limits<double>::infinity();
        return outlook.start + lengths * std::max(rear_ - outlook.front, 0.1) / outlook.fastest;
      }
      Left
      time_left(const StageView &stage, std::vector<double> &memory) const override
      {
        if (memory.empty())
          memory = {std::min(velocity_, debris_share * stage.fastest())};
        const double past = stage.time() - stage.start(), least = memory[least_velocity];
        if (memory.size() == 1)
          {
            // until something has come through, look at every step
            const double fastest = stage.fastest();
            if (past > 0 && fastest < least)
              return {0., stage.time(),
                      "nothing has come through '" + name_ + "': after " + std::to_string(past) +
                          " us nothing is faster than " + std::to_string(fastest) + " cm/us, a tenth of what came is " +
                          std::to_string(least)};
            const double step = stage.finest_cell() / std::max(fastest, least);
            if (!(past > 0) || !(stage.beyond(rear_, least).momentum > 0))
              return {step, stage.time() + 10. * step};
            memory = {least, past * growth, 0., 0., 0., 0.};
          }
        if (past < memory[next_look] * (1. - 1e-9))
          return {memory[next_look] - past, stage.time() + memory[next_look] - past};
        const double momentum = stage.beyond(rear_, least).momentum;
        const double all      = stage.beyond(-std::numeric_limits<double>::infinity(), least).momentum;
        if (!(all > 0))
          return {0., stage.time(),
                  "nothing flies on from '" + name_ + "': after " + std::to_string(past) +
                      " us nothing in the domain is faster than " + std::to_string(least) + " cm/us"};
        if (memory[half_through] == 0 && momentum >= 0.5 * all)
          memory[half_through] = past;
        const bool through = memory[half_through] > 0;
        const bool quiet =
            through && memory[one_before] > 0 && std::abs(momentum - memory[one_before]) <= share * momentum;
        memory = {least,    memory[next_look] * growth, quiet ? memory[quiet_looks] + 1. : 0., memory[last_momentum],
                  momentum, memory[half_through]};
        const bool come = stage.coming(least) <= share_still_coming * all;
        if ((come && memory[quiet_looks] >= 2.) || (through && past >= longest * memory[half_through]))
          return {0., stage.time()};
        if (through && std::isfinite(next_front_))
          {
            // what is through must not fly on to where the next body has not entered yet
            const double gap = next_front_ - stage.foremost() - safe_cells * stage.finest_cell();
            if (gap <= 0)
              return {0., stage.time()};
            memory[next_look] =
                std::min(memory[next_look], past + std::max(gap, stage.finest_cell()) / stage.fastest());
          }
        return {memory[next_look] - past, stage.time() + memory[next_look] - past};
      }

    private:
      /// What the memory holds; before anything has come through the first alone.
      enum Memory : std::size_t
      {
        least_velocity, ///< of debris, cm/us
        next_look,      ///< time since the start, us
        quiet_looks,    ///< in a row
        one_before,     ///< momentum beyond the plate at the look before the last, g cm/us
        last_momentum,  ///< ... at the last
        half_through    ///< when half of the momentum was through, us; 0: not yet
      };

      static constexpr double growth = 1.1;
      static constexpr double share = 0.01, longest = 8.;
      static constexpr double safe_cells = 8;

      std::string name_;
      double      rear_;       ///< of the plate, cm
      double      next_front_; ///< face of the nearest body beyond it, cm
      double      velocity_;   ///< a share of the fastest body's, cm/us
    };

    const StageEndRegistration
        registration("until debris is free of",
                     {"'until debris is free of BODY'",
                      "when half of the momentum is behind that plate and gains less than 1 % in a sixth of the time",
                      [](const StageEndInput &input) -> std::shared_ptr<const StageEnd> {
                        const std::size_t body = input.body(input.rest);
                        if (!(input.largest_speed > 0))
                          input.reject("nothing moves in this scene; allowed is a time");
                        double next = std::numeric_limits<double>::infinity();
                        for (const double front : input.fronts)
                          if (front >= input.rears[body])
                            next = std::min(next, front);
                        return std::make_shared<EndWhenDebrisIsFree>(input.bodies[body], input.rears[body], next,
                                                                     input.debris_velocity());
                      }});
  } // namespace
} // namespace whipple
