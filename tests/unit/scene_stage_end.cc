// SPDX-License-Identifier: LGPL-2.1-or-later
// Stage ends: what is understood, what is foretold, and when a stage that settles has settled.
#include <whipple/error.h>
#include <whipple/scene/stage_end.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;

  /// A stage in which a crater grows as depth (1 - exp(-t / tau)), and material flies at a plate.
  class FakeStage : public StageView
  {
  public:
    double now = 0, begin = 0, tau = 1, tau_of_arrival = 1, drift = 0;
    double all_is_there = 0; ///< us; until then a twentieth of the momentum waits outside the mesh

    double
    time() const override
    {
      return now;
    }
    double
    start() const override
    {
      return begin;
    }
    double
    finest_cell() const override
    {
      return 0.01;
    }
    double
    foremost() const override
    {
      return 0.5 * now;
    }
    double
    fastest() const override
    {
      return 0.5;
    }
    Debris
    beyond(double plane, double) const override
    {
      // beyond the plate nothing for 0.1 us, then momentum and kinetic energy that tend to 1; 1 in all
      const double share = plane < -1. ? 1. : now < 0.1 ? 0. : 1. - std::exp(-(now - 0.1) / tau_of_arrival);
      return {1., share, share};
    }
    double
    coming(double) const override
    {
      return now < all_is_there ? 0.05 : 0.;
    }
    std::map<std::string, double>
    watched() const override
    {
      const double crater = 0.2 * (1. - std::exp(-(now - begin) / tau));
      return {{"crater of wall", crater}, {"dent of wall", crater + drift * now}, {"hole of wall", 0.}};
    }
  };

  std::shared_ptr<const StageEnd>
  read(const std::string &text)
  {
    StageEndInput input;
    input.rest          = text;
    input.bodies        = {"bumper", "wall"};
    input.fronts        = {0., 2.};
    input.rears         = {0.1, 2.1};
    input.largest_speed = 0.5;
    input.value = [](const std::string &part, const units::Quantity &quantity) { return units::parse(part, quantity); };
    input.body  = [](const std::string &name) -> std::size_t {
      if (name == "wall")
        return 1;
      if (name == "bumper")
        return 0;
      throw InputError("unknown '" + name + "'");
    };
    input.reject = [](const std::string &allowed) { throw InputError(allowed); };
    return StageEndRegistry::read(input);
  }

  /// Go on in steps of at most that until the stage is over. @returns the time of that
  double
  run(const StageEnd &end, FakeStage &stage, double step)
  {
    std::vector<double> memory;
    stage.now = stage.begin;
    for (int i = 0; i < 1000000; ++i)
      {
        const StageEnd::Left left = end.time_left(stage, memory);
        if (left.time <= 0)
          return stage.now;
        stage.now += std::min(step, left.time);
      }
    return HUGE_VAL;
  }

  TEST(StageEnd, TimesAreForetoldAndKept)
  {
    FakeStage stage;
    stage.begin = 1.;
    EXPECT_EQ(read("1.5 us")->fixed_time(), std::optional<double>(1.5));
    EXPECT_EQ(read("1.5 us")->expected({2., 0., 0.}), 2.);
    EXPECT_EQ(read("for 2 us")->expected({1., 0., 0.}), 3.);
    EXPECT_NEAR(run(*read("1.5 us"), stage, 0.07), 1.5, 1e-8);
    EXPECT_NEAR(run(*read("for 2 us"), stage, 0.07), 3., 1e-8);
  }

  TEST(StageEnd, LeadingEdgeReachesTheFace)
  {
    FakeStage  stage;
    const auto end = read("until leading edge reaches wall");
    EXPECT_EQ(end->awaited_body(), std::optional<std::size_t>(1));
    EXPECT_FALSE(end->is_known());
    EXPECT_EQ(end->expected({0., 1., 0.5}), 2.);
    EXPECT_EQ(end->expected({0., 1., 0.}), HUGE_VAL);
    const double time = run(*end, stage, 0.07);
    EXPECT_NEAR(0.5 * time, 2., 0.01 * stage.finest_cell() + 0.1 * stage.finest_cell());
  }

  /// What changes as exp(-t / tau) changes by the share s over the time T from t = tau ln((1 - e^(-T/tau)) e^(T/tau) /
  /// s) on, up to the distance of two looks.
  TEST(StageEnd, WhatDecaysHasSettledWhenItChangesNoMore)
  {
    for (const double step : {0.003, 0.01, 0.5})
      {
        FakeStage stage;
        stage.begin              = 3.;
        const double share       = 0.01;
        const double length      = 2.;
        const double change      = (std::exp(length) - 1.) / share; // e^(t) at which the last 2 us changed by 1 %
        const double independent = stage.begin + std::log(change);
        EXPECT_NEAR(run(*read("until settled within 1 % for 2 us"), stage, step), independent, length / 10. + 1e-9)
            << step;
      }
  }

  /// Momentum that tends to 1 as 1 - exp(-(t - 0.1)): between looks a factor 1.21 apart it grows by less than 1 % from
  /// the root of e^-(t/1.21 - 0.1) - e^-(t - 0.1) = 0.01 (1 - e^-(t - 0.1)) on. That must be seen twice, one look (1.1)
  /// apart, and the first look after it may be another one late.
  TEST(StageEnd, DebrisIsFreeWhenItsMomentumGrowsNoMore)
  {
    const auto growth = [](double t) {
      return (std::exp(-(t / 1.21 - 0.1)) - std::exp(-(t - 0.1))) - 0.01 * (1. - std::exp(-(t - 0.1)));
    };
    double low = 3., high = 9.;
    for (int i = 0; i < 60; ++i)
      (growth(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
    EXPECT_NEAR(low, 4.80, 0.3);
    for (const double step : {0.003, 0.02})
      {
        FakeStage    stage;
        const double end = run(*read("until debris is free of wall"), stage, step);
        EXPECT_GE(end, 1.1 * low * (1. - 1e-6));
        EXPECT_LE(end, 1.21 * low * (1. + 1e-6));
      }
  }

  /// A stage in which everything has come to rest before the plate.
  struct StageAtRest : FakeStage
  {
    double speed = 0.04; ///< cm/us

    double
    fastest() const override
    {
      return speed;
    }
  };
  TEST(StageEnd, APlateThatHoldsEndsTheChain)
  {
    StageAtRest         stage;
    std::vector<double> memory;
    // debris that is slow from the start on is not at rest: a tenth of what came is what counts
    read("until debris is free of wall")->time_left(stage, memory);
    stage.now = stage.begin + 0.05;
    EXPECT_GT(read("until debris is free of wall")->time_left(stage, memory).time, 0.);
    stage.speed     = 0.003;
    const auto left = read("until debris is free of wall")->time_left(stage, memory);
    EXPECT_EQ(left.time, 0.);
    ASSERT_TRUE(left.chain_over);
    EXPECT_NE(left.chain_over->find("'wall'"), std::string::npos) << *left.chain_over;
    EXPECT_FALSE(read("for 2 us")->time_left(stage, memory).chain_over);
    EXPECT_FALSE(read("until leading edge reaches wall")->time_left(stage, memory).chain_over);
    stage.speed = 0.;
    EXPECT_TRUE(read("until leading edge reaches wall")->time_left(stage, memory).chain_over);
  }

  /// A stage does not end while more than 1 % of the momentum is on its way to it; once all is there it ends within the
  /// next looks.
  TEST(StageEnd, WaitsForDebrisThatWillArrive)
  {
    FakeStage stage;
    stage.all_is_there = 40.;
    EXPECT_NEAR(run(*read("until settled within 1 % for 2 us"), stage, 0.05), 40., 0.2 + 1e-9);
    stage.all_is_there = 5.5;
    const double end   = run(*read("until debris is free of wall"), stage, 0.02);
    EXPECT_GE(end, 5.5);
    EXPECT_LE(end, 5.5 * 1.1);
    // at eight times the time of the half (ln 2 + 0.1) it ends whatever is on its way
    stage.all_is_there = 1000.;
    const double last  = run(*read("until debris is free of wall"), stage, 0.02);
    EXPECT_GE(last, 8. * 0.79);
    EXPECT_LE(last, 8. * 0.79 * 1.21);
  }

  /// The crater grows as 0.2 (1 - exp(-t)) cm. Looks are a factor 1.1 apart, five of them must agree within half a
  /// cell, 0.005 cm: from the root of e^(-t/1.1^4) - e^-t = 0.025 on; the first look after that may be one later.
  TEST(StageEnd, HolesHaveSettled)
  {
    double low = 1., high = 20.;
    for (int i = 0; i < 60; ++i)
      {
        const double t                                                        = 0.5 * (low + high);
        (std::exp(-t / std::pow(1.1, 4)) - std::exp(-t) > 0.025 ? low : high) = t;
      }
    EXPECT_NEAR(low, 5.2, 0.4);
    double slow = 1., fast = 20.; // where the crater's depth grows by 0.001 cm/us between the first and the last look
    for (int i = 0; i < 60; ++i)
      {
        const double t = 0.5 * (slow + fast), first = t / std::pow(1.1, 4);
        (0.2 * (std::exp(-first) - std::exp(-t)) > 0.001 * (t - first) ? slow : fast) = t;
      }
    for (const double step : {0.003, 0.02})
      {
        FakeStage    stage;
        const double end = run(*read("until holes have settled"), stage, step);
        EXPECT_GE(end, low * (1. - 1e-6));
        EXPECT_LE(end, 1.1 * low * (1. + 1e-6));
        EXPECT_NEAR(run(*read("until holes have settled within 3 us"), stage, step), 3., 1e-8);
        // a wall that moves on as a whole, its dent growing for ever
        stage.drift = 0.004; // the fastest body has 0.5: with what the crater still grows by a dent may have 0.005
        const double moving = run(*read("until holes have settled"), stage, step);
        EXPECT_GE(moving, slow * (1. - 1e-6));
        EXPECT_LE(moving, 1.1 * slow * (1. + 1e-6));
        stage.drift = 0.1; // ... and one that is still pushed in
        EXPECT_NEAR(run(*read("until holes have settled within 30 us"), stage, step), 30., 1e-8);
        stage.drift = 0.;
        // what is on its way falls as e^-t from t = 0.1 us on; an arrival that is late is waited for
        stage.tau_of_arrival = 4.;
        const double last    = run(*read("until holes have settled and debris has reached wall"), stage, step);
        EXPECT_GE(last, 0.1 - 4. * std::log(0.02) - 1e-6);
        EXPECT_LE(last, 1.1 * (0.1 - 4. * std::log(0.02)) + 0.1);
        EXPECT_NEAR(run(*read("until holes have settled and debris has reached wall within 9 us"), stage, step), 9.,
                    1e-8);
      }
  }

  /// What is through does not fly on to the wall, which enters later: half of the momentum is through the bumper at
  /// 0.1 + 4 ln 2 = 2.87 us, and the foremost, at 0.5 t, is eight cells before the wall's face (2 cm) at 3.84 us.
  TEST(StageEnd, DebrisDoesNotFlyPastTheNextBody)
  {
    FakeStage stage;
    stage.tau_of_arrival = 4.;
    EXPECT_NEAR(run(*read("until debris is free of bumper"), stage, 0.005), 3.84, 0.03);
    stage.tau_of_arrival = 8.; // half is through at 5.65 us only: the next look after that
    const double end     = run(*read("until debris is free of bumper"), stage, 0.005);
    EXPECT_GE(end, 5.64);
    EXPECT_LE(end, 5.65 * 1.1);
  }

  TEST(StageEnd, WhatIsNotUnderstoodIsRefused)
  {
    for (const char *text : {"", "until settled", "until settled within 1 %", "until settled within 1 % for", "0 us",
                             "for -1 us", "until settled within 0 % for 2 us", "until settled within 1 % for 0 us",
                             "until leading edge reaches moon", "until holes have settled soon",
                             "until holes have settled within 0 us", "until debris is free of moon", "when it is over"})
      EXPECT_THROW(read(text), InputError) << text;
  }
} // namespace
