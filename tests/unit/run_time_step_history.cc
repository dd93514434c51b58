// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/run/time_step_history.h>

#include <gtest/gtest.h>

namespace
{
  using whipple::TimeStepHistory;

  bool
  collapses(TimeStepHistory &history, double dt, int steps)
  {
    for (int i = 0; i < steps; ++i)
      {
        history.add(dt);
        if (history.collapse())
          return true;
      }
    return false;
  }

  TEST(TimeStepHistory, NoticesWhatFallsBelowTheMedian)
  {
    TimeStepHistory history;
    EXPECT_FALSE(collapses(history, 1e-3, 500));
    EXPECT_FALSE(collapses(history, 2e-7, 1000)); // 2e-4 of it: slow, but the stage ends
    TimeStepHistory worse;
    EXPECT_FALSE(collapses(worse, 1e-3, 500));
    EXPECT_TRUE(collapses(worse, 0.9e-7, 200));
    EXPECT_NE(worse.collapse()->find("median"), std::string::npos);
  }

  TEST(TimeStepHistory, NoticesWhatFallsAtOnce)
  {
    TimeStepHistory history;
    EXPECT_FALSE(collapses(history, 1e-3, 3));
    EXPECT_TRUE(collapses(history, 0.9e-9, 400));
  }

  TEST(TimeStepHistory, AFewShortStepsAreNone)
  {
    TimeStepHistory history;
    for (int i = 0; i < 2000; ++i)
      {
        history.add(i % 50 == 0 ? 1e-3 : 1e-9);
        EXPECT_FALSE(history.collapse());
      }
  }

  TEST(TimeStepHistory, KnowsWhatIsTypical)
  {
    TimeStepHistory history;
    history.add(2e-3);
    for (int i = 1; i < 99; ++i)
      history.add(1e-3);
    EXPECT_EQ(history.typical(), 0.);
    history.add(1e-3);
    EXPECT_EQ(history.typical(), 2e-3); // the first
    for (int i = 0; i < 99; ++i)
      history.add(5e-3);
    EXPECT_EQ(history.typical(), 2e-3); // looks again at the 200th
    history.add(5e-3);
    EXPECT_EQ(history.typical(), 5e-3);
    TimeStepHistory again(history.steps());
    EXPECT_EQ(again.typical(), 5e-3);
  }

  TEST(TimeStepHistory, GoesOnFromStepsMadeBefore)
  {
    TimeStepHistory history;
    EXPECT_FALSE(collapses(history, 1e-3, 500));
    TimeStepHistory again(history.steps());
    EXPECT_FALSE(collapses(again, 1e-8, 99));
    EXPECT_TRUE(collapses(again, 1e-8, 1));
  }
} // namespace
