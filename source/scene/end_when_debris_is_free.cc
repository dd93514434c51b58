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
    /// Debris is what lies beyond the plate's rear face and is faster than a tenth of the fastest body. Looks are made
    /// at times t_0 growth^n after the start, t_0 the first time at which there is debris. It is free once half of the
    /// momentum of what is that fast is beyond the plate, grows there by less than `share` between looks two apart (in
    /// the last sixth of the time), twice in a row, and next to nothing is still coming. At the latest, once that half
    /// is through, at `longest` times the time of it, or when the foremost has come to the next body. The memory holds
    /// the time of the next look, how often it was quiet, the momenta of the last two looks, and the time of the half
    /// (0: not yet).
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
        const double past = stage.time() - stage.start(), least = memory[0];
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
        if (past < memory[1] * (1. - 1e-9))
          return {memory[1] - past, stage.time() + memory[1] - past};
        const double momentum = stage.beyond(rear_, least).momentum;
        const double all      = stage.beyond(-std::numeric_limits<double>::infinity(), least).momentum;
        if (!(all > 0))
          return {0., stage.time(),
                  "nothing flies on from '" + name_ + "': after " + std::to_string(past) +
                      " us nothing in the domain is faster than " + std::to_string(least) + " cm/us"};
        if (memory[5] == 0 && momentum >= 0.5 * all)
          memory[5] = past;
        const bool through = memory[5] > 0;
        const bool quiet   = through && memory[3] > 0 && std::abs(momentum - memory[3]) <= share * momentum;
        memory             = {least, memory[1] * growth, quiet ? memory[2] + 1. : 0., memory[4], momentum, memory[5]};
        const bool come    = stage.coming(least) <= share_still_coming * all;
        if ((come && memory[2] >= 2.) || (through && past >= longest * memory[5]))
          return {0., stage.time()};
        if (through && std::isfinite(next_front_))
          {
            // what is through must not fly on to where the next body has not entered yet
            const double gap = next_front_ - stage.foremost() - safe_cells * stage.finest_cell();
            if (gap <= 0)
              return {0., stage.time()};
            memory[1] = std::min(memory[1], past + std::max(gap, stage.finest_cell()) / stage.fastest());
          }
        return {memory[1] - past, stage.time() + memory[1] - past};
      }

    private:
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
