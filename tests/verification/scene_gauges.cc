// SPDX-License-Identifier: LGPL-2.1-or-later
// Gauges against exact solutions: when a shock arrives and what is behind it, the path of a particle, the velocity of a
// free surface; and that a failed step leaves no row.
#include "../figure.h"
#include "scene_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace
{
  using namespace whipple;
  using figure::expect_at_most;

  /// DIR/gauges/NAME.csv by column.
  using Table = std::map<std::string, std::vector<double>>;

  Table
  read_gauge(const std::string &folder, const std::string &name)
  {
    std::ifstream file("verification_output/" + folder + "/gauges/" + name + ".csv");
    std::string   line, cell;
    std::getline(file, line);
    std::vector<std::string> columns;
    for (std::istringstream names(line); std::getline(names, cell, ',');)
      columns.push_back(cell);
    Table table;
    while (std::getline(file, line))
      {
        std::istringstream cells(line);
        for (const std::string &column : columns)
          {
            std::getline(cells, cell, ',');
            table[column].push_back(std::stod(cell));
          }
      }
    return table;
  }

  /// Time at which a column first rises through a level, linear between rows; -1: never.
  double
  rises_through(const Table &table, const std::string &column, double level)
  {
    const std::vector<double> &time = table.at("time [us]"), &value = table.at(column);
    for (std::size_t i = 1; i < time.size(); ++i)
      if (value[i - 1] < level && value[i] >= level)
        return time[i - 1] + (level - value[i - 1]) / (value[i] - value[i - 1]) * (time[i] - time[i - 1]);
    return -1;
  }

  std::vector<std::string>
  gauge(const std::string &name, const std::vector<std::string> &entries)
  {
    std::vector<std::string> settings;
    for (const std::string &entry : entries)
      settings.push_back("Gauges/" + name + "/" + entry);
    return settings;
  }

  std::vector<std::string>
  operator+(std::vector<std::string> a, const std::vector<std::string> &b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  /// Shock of Sod's tube in gas at rest [Toro2009]: p* = 0.30313, u* = 0.92745, speed 1.75216, from 0.5 cm.
  constexpr double shock_speed = 1.75216, behind_pressure = 0.30313, behind_velocity = 0.92745, shock_start = 0.5;

  void
  sod(const std::string &mode, double arrival_tolerance, double path_tolerance)
  {
    const std::string folder = "gauges_sod_" + mode;
    verification::run("verification/sod.prm",
                      std::vector<std::string>{"Mesh/Finest cell = 0.005 cm", "Stages/tube/Mode = " + mode,
                                               "Gauges/List = wall, rider"} +
                          gauge("wall", {"Point = 0.01 cm, 0.7 cm", "Fields = pressure, velocity"}) +
                          gauge("rider", {"Kind = material", "Point = 0.01 cm, 0.602 cm", "Interval = 0.01 us"}),
                      folder);
    const Table  wall    = read_gauge(folder, "wall");
    const double arrival = rises_through(wall, "pressure [Mbar]", 0.5 * (0.1 + behind_pressure));
    expect_at_most(mode + ": arrival of Sod's shock at a gauge, us", arrival - (0.7 - shock_start) / shock_speed,
                   arrival_tolerance);
    EXPECT_NEAR(wall.at("pressure [Mbar]").back(), behind_pressure, 2e-3);
    EXPECT_NEAR(wall.at("velocity 1 [cm/us]").back(), behind_velocity, 5e-3);
    EXPECT_EQ(wall.at("position 1 [cm]").back(), 0.7);
    EXPECT_EQ(wall.at("time [us]").front(), 0.);

    const Table  rider = read_gauge(folder, "rider");
    const double start = 0.602, met = (start - shock_start) / shock_speed, last = rider.at("time [us]").back();
    expect_at_most(mode + ": path of a particle through Sod's shock, cm",
                   rider.at("position 1 [cm]").back() - (start + behind_velocity * (last - met)), path_tolerance);
    EXPECT_NEAR(rider.at("position 0 [cm]").back(), 0.01, 1e-12);
    const std::size_t rows = rider.at("time [us]").size();
    EXPECT_GE(rows, 15u); // 0.2 us by 0.01 us, each at the end of a step
    EXPECT_LE(rows, 21u);
  }

  TEST(Gauges, SeeTheShockOfSodEulerian)
  {
    sod("eulerian", 2e-3, 2e-3);
  }
  TEST(Gauges, SeeTheShockOfSodLagrangian)
  {
    sod("lagrangian", 2e-3, 2e-3);
  }

  /// A gauge that rides goes round with a steady vortex; how far it is off after 1 rad, cm.
  double
  off_course(const std::string &mode, const std::string &cell)
  {
    constexpr double  x = 0.8, y = 0.6, turns = 0.5; // rad/us, 1 cm from the centre
    const std::string folder = "gauges_vortex_" + mode + "_" + cell.substr(0, cell.find(' '));
    verification::run("verification/isentropic_vortex.prm",
                      std::vector<std::string>{"Mesh/Finest cell = " + cell, "Stages/turn/Mode = " + mode,
                                               "Stages/turn/End = 2 us", "Gauges/List = rider"} +
                          gauge("rider", {"Kind = material", "Point = 0.8 cm, 0.6 cm"}),
                      folder);
    const Table  rider = read_gauge(folder, "rider");
    const double angle = turns * rider.at("time [us]").back();
    return std::hypot(rider.at("position 0 [cm]").back() - (x * std::cos(angle) - y * std::sin(angle)),
                      rider.at("position 1 [cm]").back() - (x * std::sin(angle) + y * std::cos(angle)));
  }

  TEST(Gauges, RideOnACircle)
  {
    for (const std::string mode : {"eulerian", "lagrangian"})
      {
        const double coarse = off_course(mode, "0.25 cm"), fine = off_course(mode, "0.125 cm");
        expect_at_most(mode + ": riding gauge off its circle of 1 cm after 1 rad, cells of 0.125 cm, cm", fine, 0.02);
        EXPECT_GE(coarse / fine, 2.8) << mode << ", order below 1.5: " << coarse << " and " << fine << " cm";
      }
  }

  /// The rear face of a plate that another one has hit: its velocity behind the shock's arrival until the end.
  Table
  rear_face(const std::string &mode, const std::string &velocity, const std::string &end, const std::string &folder)
  {
    verification::run("verification/aluminium_impact.prm",
                      std::vector<std::string>{"Stages/impact/Mode = " + mode, "Stages/impact/End = " + end,
                                               "Bodies/flyer/Velocity = 0 km/s, " + velocity,
                                               "Effects/List = body tags", "Gauges/List = laser"} +
                          gauge("laser", {"Kind = surface velocity", "Body = target", "Side = rear"}),
                      folder);
    return read_gauge(folder, "laser");
  }

  double
  mean_after(const Table &table, const std::string &column, double time)
  {
    double sum = 0, number = 0;
    for (std::size_t i = 0; i < table.at("time [us]").size(); ++i)
      if (table.at("time [us]")[i] >= time)
        {
          sum += table.at(column)[i];
          ++number;
        }
    return sum / number;
  }

  /// 1.029 times 0.658 cm/us behind 89 GPa (doc/theory/exact_solid.md); the shock arrives at 1 cm / 0.9730 cm/us.
  TEST(Gauges, SeeTheFreeSurfaceBehindAStrongShock)
  {
    for (const std::string mode : {"eulerian", "lagrangian"})
      {
        const std::string folder   = "gauges_strong_" + mode;
        const Table       laser    = rear_face(mode, "6.58 km/s", "1.4 us", folder);
        const double      expected = 1.029 * 0.658;
        expect_at_most(mode + ": free-surface velocity behind 89 GPa, relative error",
                       mean_after(laser, "velocity 1 [cm/us]", 1.2) / expected - 1., 0.01);
        const double arrival = rises_through(laser, "velocity 1 [cm/us]", 0.5 * expected);
        expect_at_most(mode + ": arrival of the shock at the free surface, us", arrival - 1. / 0.9730, 0.02);
        EXPECT_NEAR(laser.at("position 1 [cm]").front(), 1., 1e-12);
      }
  }

  /// Weak shocks: twice the particle velocity, which by symmetry is half the velocity of impact.
  TEST(Gauges, SeeTwiceTheParticleVelocity)
  {
    for (const std::string mode : {"eulerian", "lagrangian"})
      {
        const Table laser = rear_face(mode, "0.5 km/s", "2.4 us", "gauges_weak_" + mode);
        expect_at_most(mode + ": free-surface velocity / 2 u_p - 1, weak shock",
                       mean_after(laser, "velocity 1 [cm/us]", 2.1) / 0.05 - 1., 0.01);
      }
  }

  /// Steps that fail are undone and leave no row: one row a step that stood, and the start.
  TEST(Gauges, FailedStepsLeaveNoRow)
  {
    const auto simulation =
        verification::run("verification/sod.prm",
                          std::vector<std::string>{"Numerics/Inject failure at step = 17",
                                                   "Numerics/Injected failures = 2", "Gauges/List = wall"} +
                              gauge("wall", {"Point = 0.01 cm, 0.7 cm"}),
                          "gauges_retry");
    const Table wall = read_gauge("gauges_retry", "wall");
    EXPECT_EQ(simulation->summary().counts.retries, 2);
    const std::vector<double> &time = wall.at("time [us]");
    EXPECT_EQ(static_cast<long>(time.size()), 1 + simulation->summary().stages[0].steps);
    EXPECT_TRUE(std::adjacent_find(time.begin(), time.end(), std::greater_equal<>()) == time.end());
  }
} // namespace
