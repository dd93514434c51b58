// SPDX-License-Identifier: LGPL-2.1-or-later
#include "complaint.h"

#include <whipple/error.h>
#include <whipple/study/analysis.h>
#include <whipple/study/quantity_name.h>
#include <whipple/study/tolerance.h>
#include <whipple/study/tolerance_run.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;

  /// A plan without points whose scene has a bumper, debris and an exact solution.
  StudyPlan
  plan_with_results()
  {
    StudyPlan plan;
    plan.has_exact_solution = true;
    plan.results["bumper"]  = {{"hole_diameter_cm", 0.}, {"smallest_hole_diameter_cm", 0.}, {"perforated", false}};
    plan.results["debris"]  = {{"leading_edge_velocity_cm_per_us", 0.}, {"cone_angle_deg", 0.}, {"radius_95_cm", 0.}};
    return plan;
  }

  std::string
  complaint(const std::string &text)
  {
    return complaint_of([&] { read_tolerance(text, plan_with_results()); });
  }

  TEST(StudyTolerance, NamesAreMatchedByTheirWords)
  {
    const StudyPlan plan = plan_with_results();
    const auto      hole = read_tolerance("bumper hole diameter = 2 %", plan);
    EXPECT_EQ(hole.quantity, (Quantity{false, "bumper", "hole_diameter_cm"}));
    EXPECT_TRUE(hole.relative);
    EXPECT_DOUBLE_EQ(hole.amount, 0.02);
    EXPECT_EQ(read_tolerance("Smallest hole=200 um", plan).quantity.name, "smallest_hole_diameter_cm");
    EXPECT_DOUBLE_EQ(read_tolerance("smallest hole = 200 um", plan).amount, 0.02);
    EXPECT_EQ(read_tolerance("leading_edge_velocity = 10 m/s", plan).quantity.place, "debris");
    EXPECT_DOUBLE_EQ(read_tolerance("leading edge velocity = 10 m/s", plan).amount, 0.001);
    EXPECT_DOUBLE_EQ(read_tolerance("cone angle = 0.5 deg", plan).amount, 0.5);
    EXPECT_EQ(read_tolerance("density = 0.01 g/cm^3", plan).quantity, (Quantity{true, "density", "L1"}));
    EXPECT_EQ(read_tolerance("density linf = 1 %", plan).quantity, (Quantity{true, "density", "Linf"}));
    EXPECT_EQ(read_tolerance("shock position = 0.1 mm", plan).quantity.place, "shock position");
  }

  TEST(StudyTolerance, WhatDoesNotFitIsOneLine)
  {
    EXPECT_NE(complaint("crater = 2 %").find("no such result; allowed are"), std::string::npos);
    EXPECT_NE(complaint("crater = 2 %").find("bumper hole diameter"), std::string::npos);
    EXPECT_NE(complaint("hole = 2 %").find("may mean any of"), std::string::npos);
    EXPECT_NE(complaint("bumper perforated = 2 %").find("no such result"), std::string::npos);
    for (const char *text :
         {"bumper hole diameter", "= 2 %", "", "bumper hole diameter = 0 %", "bumper hole diameter = -1 cm",
          "bumper hole diameter = 1 us", "cone angle = 1 cm", "bumper hole diameter = 2"})
      {
        EXPECT_NE(complaint(text), "") << text;
        EXPECT_EQ(complaint(text).find('\n'), std::string::npos) << text;
      }
  }

  TEST(StudyTolerance, Budgets)
  {
    EXPECT_EQ(read_budget("90 s"), 90.);
    EXPECT_EQ(read_budget("20 min"), 1200.);
    EXPECT_EQ(read_budget("1.5h"), 5400.);
    for (const char *text : {"", "20", "min", "0 s", "-1 h", "2 days", "nan s", "inf s"})
      EXPECT_THROW(read_budget(text), InputError) << text;
  }

  /// A series of runs with hole diameter 0.64 + 2 h and 10 us a cell step, cell steps 1 / h^3.
  StudyPlan
  linear_plan()
  {
    StudyPlan plan = plan_with_results();
    StudyAxis axis{"cell", {cell_parameter}, {}, 0, ""};
    for (const double cell : {0.04, 0.02, 0.01, 0.005, 0.0025})
      axis.values.push_back({std::to_string(cell), {std::to_string(cell)}, cell});
    plan.section.axes = {axis};
    for (std::size_t v = 0; v < axis.values.size(); ++v)
      plan.points.push_back({axis.values[v].label, {v}, {}, 1, *axis.values[v].cell, ""});
    return plan;
  }

  std::vector<PointOutcome>
  outcomes_of(const StudyPlan &plan, std::size_t count)
  {
    std::vector<PointOutcome> outcomes;
    for (std::size_t i = 0; i < count; ++i)
      {
        const double cell = plan.points[i].cell;
        PointRecord  record;
        record.status                                = "completed";
        record.cost.active_cell_steps                = std::pow(cell, -3.);
        record.cost.wall_s                           = 1e-5 * record.cost.active_cell_steps;
        record.results["bumper"]["hole_diameter_cm"] = 0.64 + 2. * cell;
        record.results["bumper"]["perforated"]       = cell < 0.03;
        record.errors["density"]                     = {{"L1", 3. * cell}};
        outcomes.push_back({plan.points[i], record});
      }
    return outcomes;
  }

  TEST(StudyForecast, ErrorAndTimeOfFinerCells)
  {
    const StudyPlan      plan      = linear_plan();
    const Tolerance      tolerance = read_tolerance("bumper hole diameter = 0.02 cm", plan);
    const MethodForecast method    = forecast_method(plan, outcomes_of(plan, 3), tolerance, "base");
    ASSERT_EQ(method.excluded, "");
    ASSERT_EQ(method.rows.size(), 5u);
    EXPECT_NEAR(method.error.exponent, 1., 1e-6);
    for (const CellForecast &row : method.rows)
      {
        // what has run is known but for the limit: a quarter of the finest run's error
        EXPECT_NEAR(row.error, row.computed ? 2. * row.cell + 0.25 * 2. * 0.01 : 1.25 * 2. * row.cell, 1e-8);
        EXPECT_NEAR(row.seconds, 1e-5 * std::pow(row.cell, -3.), 1e-6);
        EXPECT_EQ(row.computed, row.cell > 0.009);
      }
    // the table ends with the first cells that reach the tolerance
    EXPECT_NE(forecast_table(method, tolerance).find("| 0.005 cm |"), std::string::npos);
    EXPECT_EQ(forecast_table(method, tolerance).find("| 0.0025 cm |"), std::string::npos);
  }

  TEST(StudyForecast, ExactErrorsFollowTheirPowerLaw)
  {
    const StudyPlan      plan      = linear_plan();
    const Tolerance      tolerance = read_tolerance("density = 0.01 g/cm^3", plan);
    const MethodForecast method    = forecast_method(plan, outcomes_of(plan, 3), tolerance, "base");
    ASSERT_EQ(method.excluded, "");
    EXPECT_NEAR(method.rows[4].error, 3. * 0.0025, 1e-12);
    // nothing says what 1 % would be of
    const MethodForecast relative =
        forecast_method(plan, outcomes_of(plan, 3), read_tolerance("density = 1 %", plan), "base");
    EXPECT_NE(relative.excluded, "");
  }

  TEST(StudyForecast, ARunThatStoppedExcludesItsMethod)
  {
    const StudyPlan plan      = linear_plan();
    auto            outcomes  = outcomes_of(plan, 3);
    outcomes[1].record.status = "stopped";
    outcomes[1].record.reason = "negative volume";
    const auto method = forecast_method(plan, outcomes, read_tolerance("bumper hole diameter = 2 %", plan), "base");
    EXPECT_NE(method.excluded.find("stopped: negative volume"), std::string::npos);
    EXPECT_TRUE(method.rows.empty());
  }

  TEST(StudyAnalysis, SeriesReferenceAndVerdicts)
  {
    const StudyPlan     plan     = linear_plan();
    const auto          outcomes = outcomes_of(plan, 4);
    const StudyAnalysis analysis = analyse(plan, outcomes);
    ASSERT_EQ(analysis.series.size(), 1u);
    const Series &series = analysis.series[0];
    EXPECT_EQ(series.points.size(), 4u);
    ASSERT_EQ(series.results.size(), 1u);
    EXPECT_NEAR(*series.results[0].orders[3], 1., 1e-6);
    EXPECT_NEAR(*series.results[0].estimate.extrapolated, 0.64, 1e-9);
    ASSERT_EQ(series.errors.size(), 1u);
    EXPECT_NEAR(*series.errors[0].orders[1], 1., 1e-12);
    ASSERT_EQ(series.verdicts.size(), 1u);
    EXPECT_FALSE(series.verdicts[0].levels[0].second);
    EXPECT_TRUE(series.verdicts[0].levels[1].second);
    const auto error = point_error(analysis, outcomes[0].record, series.results[0].quantity);
    EXPECT_TRUE(error->relative);
    EXPECT_NEAR(error->error, 0.08 / 0.64, 1e-6);
  }

  TEST(StudyNames, KeysForPeople)
  {
    EXPECT_EQ(readable_quantity("hole_diameter_cm"), "hole diameter, cm");
    EXPECT_EQ(readable_quantity("axial_momentum_g_cm_per_us"), "axial momentum, g cm/us");
    EXPECT_EQ(readable_quantity("leading_edge_velocity_cm_per_us"), "leading edge velocity, cm/us");
    EXPECT_EQ(readable_quantity("radius_95_cm"), "radius 95, cm");
    EXPECT_EQ(readable_quantity("perforated"), "perforated");
    EXPECT_EQ(readable_quantity("mass_g"), "mass, g");
  }
} // namespace
