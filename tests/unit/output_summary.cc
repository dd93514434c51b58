// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/summary.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <limits>

namespace
{
  using namespace whipple;
  using Json = nlohmann::json;

  summary::Summary
  example()
  {
    summary::Summary s;
    s.scene = "whipple shield";
    s.stages.push_back({.name                      = "perforation",
                        .mode                      = "eulerian",
                        .start_us                  = 0,
                        .end_us                    = 1.5,
                        .steps                     = 700,
                        .active_cells_max          = 20000,
                        .finest_equivalent_cells   = 400000,
                        .elements                  = {},
                        .wall_s                    = 3,
                        .cell_steps                = 1.4e7,
                        .cell_steps_per_s_per_rank = 4.6e6,
                        .dt_limits                 = {{"sound speed", 699}, {"growth", 1}}});
    s.ledger.mass                   = {.initial          = 0.0463,
                                       .final_value      = 0.0462,
                                       .left_domain      = 1e-4,
                                       .dropped          = {{"thin", 0.}},
                                       .closure_relative = 1e-16,
                                       .extra            = {}};
    s.ledger.energy.extra           = {{"kinetic", 0.01}, {"plastic_work", 1e-4}};
    s.ledger.bodies["sphere"]       = {{"mass_g", 0.0463}};
    s.results["bumper"]             = {{"hole_diameter_cm", 0.648}, {"perforated", true}};
    s.results["wall"]               = {{"hole_diameter_cm", std::monostate{}},
                                       {"edges_cm", std::vector<double>{0., 0.5, std::numeric_limits<double>::infinity()}}};
    s.effects["voids"]              = {true, 12.5, "shock reverberation exceeds spall strength"};
    s.performance.ranks             = 2;
    s.performance.active_cell_steps = 1.4e7;
    s.counts.warnings               = 1;
    return s;
  }

  TEST(Summary, HasTheKeysOfTheInterface)
  {
    const Json json = Json::parse(summary::to_json(example()));
    EXPECT_EQ(json["schema"], 1);
    for (const char *key :
         {"scene", "status", "reason", "stages", "ledger", "results", "errors", "performance", "effects", "counts"})
      EXPECT_TRUE(json.contains(key)) << key;
    const Json &stage = json["stages"][0];
    for (const char *key : {"name", "mode", "start_us", "end_us", "steps", "active_cells_max", "elements", "wall_s",
                            "cell_steps", "cell_steps_per_s_per_rank", "dt_limits"})
      EXPECT_TRUE(stage.contains(key)) << key;
    for (const char *quantity : {"mass_g", "axial_momentum_g_cm_per_us", "energy_Mbar_cm3"})
      for (const char *key : {"initial", "final", "left_domain", "dropped", "closure_relative"})
        EXPECT_TRUE(json["ledger"][quantity].contains(key)) << quantity << ' ' << key;
    for (const char *key : {"wall_s", "cpu_s", "peak_rss_bytes", "ranks", "active_cell_steps"})
      EXPECT_TRUE(json["performance"][key].is_number()) << key;
    for (const char *key : {"retries", "releases", "rezones", "warnings"})
      EXPECT_TRUE(json["counts"][key].is_number_integer()) << key;
  }

  TEST(Summary, ValuesArriveWithTheirTypes)
  {
    const Json json = Json::parse(summary::to_json(example()));
    EXPECT_EQ(json["stages"][0]["dt_limits"]["sound speed"], 699);
    EXPECT_EQ(json["ledger"]["energy_Mbar_cm3"]["plastic_work"], 1e-4);
    EXPECT_EQ(json["ledger"]["bodies"]["sphere"]["mass_g"], 0.0463);
    EXPECT_EQ(json["results"]["bumper"]["hole_diameter_cm"], 0.648);
    EXPECT_EQ(json["results"]["bumper"]["perforated"], true);
    EXPECT_EQ(json["results"]["wall"]["edges_cm"], Json({0., 0.5, nullptr}));
    EXPECT_EQ(json["effects"]["voids"]["on"], true);
  }

  TEST(Summary, ListsOfNumbersAreOneLine)
  {
    summary::Summary s = example();
    s.scene            = "a \\ name [ 1,\n 2 ] with \" everything\\";
    const auto text    = summary::to_json(s);
    EXPECT_NE(text.find("\"edges_cm\": [0.0, 0.5, null]"), std::string::npos) << text;
    EXPECT_EQ(Json::parse(text)["scene"], s.scene);
    EXPECT_EQ(Json::parse(text)["stages"].size(), 1u);
  }

  TEST(Summary, WhatDoesNotApplyIsNull)
  {
    summary::Summary s  = example();
    s.stages[0].end_us  = std::numeric_limits<double>::quiet_NaN();
    s.ledger.mass.extra = {{"lost", std::numeric_limits<double>::infinity()}};
    const Json json     = Json::parse(summary::to_json(s));
    EXPECT_TRUE(json["reason"].is_null());
    EXPECT_TRUE(json["errors"].is_null());
    EXPECT_TRUE(json["stages"][0]["elements"].is_null());
    EXPECT_TRUE(json["stages"][0]["end_us"].is_null());
    EXPECT_TRUE(json["ledger"]["mass_g"]["lost"].is_null());
    EXPECT_TRUE(json["ledger"]["energy_Mbar_cm3"]["closure_relative"].is_null());
    EXPECT_TRUE(json["results"]["wall"]["hole_diameter_cm"].is_null());
    EXPECT_TRUE(json["results"].is_object());
  }

  TEST(Summary, ErrorsAndReasonWhenThereAre)
  {
    summary::Summary s  = example();
    s.status            = "stopped";
    s.reason            = "negative volume";
    s.errors["density"] = {4.4e-3, {}, 0.1};
    const Json json     = Json::parse(summary::to_json(s));
    EXPECT_EQ(json["reason"], "negative volume");
    EXPECT_EQ(json["errors"]["density"]["L1"], 4.4e-3);
    EXPECT_TRUE(json["errors"]["density"]["L2"].is_null());
  }

  TEST(Summary, IsWrittenInOnePiece)
  {
    namespace fs             = std::filesystem;
    const fs::path directory = fs::current_path() / "whipple_summary_test";
    fs::remove_all(directory);
    fs::create_directories(directory);
    summary::write(example(), directory.string());
    std::ifstream file(directory / "summary.json");
    EXPECT_EQ(Json::parse(file)["scene"], "whipple shield");
    EXPECT_EQ(std::distance(fs::directory_iterator(directory), fs::directory_iterator{}), 1);
    EXPECT_THROW(summary::write(example(), (directory / "missing").string()), std::runtime_error);
    fs::remove_all(directory);
  }
} // namespace
