// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole scenes through the program's own chain of stages, against exact solutions for solids.
#include "../figure.h"
#include "scene_run.h"

#include <algorithm>

namespace
{
  using namespace whipple;
  using figure::expect_relative;
  using verification::CellSample;
  using verification::falls_through;
  using verification::mean;

  /// Mie-Grueneisen Al 2024-T4 at an impact velocity of 0.658 cm/us: exact Hugoniot and release.
  class ScenePlateImpact : public testing::TestWithParam<const char *>
  {
  };

  TEST_P(ScenePlateImpact, HugoniotAndRelease)
  {
    const std::string mode = GetParam();
    const double      rho0 = 2.785, c0 = 0.5328, s = 1.338, up = 0.329, us = c0 + s * up;

    // before the shock reaches the rear face: the plateau and the shock speed
    const auto shocked = verification::samples(
        *verification::run("verification/aluminium_impact.prm",
                           {"Stages/impact/Mode = " + mode, "Stages/impact/End = 0.8 us"}, "impact_" + mode));
    expect_relative("Al-Al impact: pressure, Mbar", mean(shocked, &CellSample::pressure, 0.35, 0.7), rho0 * us * up,
                    0.01);
    expect_relative("Al-Al impact: density, g/cm^3", mean(shocked, &CellSample::density, 0.35, 0.7),
                    rho0 * us / (us - up), 0.01);
    expect_relative("Al-Al impact: shock speed, cm/us",
                    falls_through(shocked, &CellSample::velocity, 0.5 * up, 0.35) / 0.8, us, 0.01);

    // after it: the released face
    const auto released = verification::samples(
        *verification::run("verification/aluminium_impact.prm", {"Stages/impact/Mode = " + mode}, "release_" + mode));
    double front = 0;
    for (const CellSample &c : released)
      front = std::max(front, c.x[1]);
    expect_relative("Al-Al impact: release velocity, cm/us",
                    mean(released, &CellSample::velocity, front - 0.08, front - 0.03), 1.0287 * 0.658, 0.01);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, ScenePlateImpact, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  /// Elastic-plastic piston, hypoelastic exact solution [ExactPack].
  class ScenePiston : public testing::TestWithParam<const char *>
  {
  };

  TEST_P(ScenePiston, BothPlateausAndBothWaveSpeeds)
  {
    const std::string mode  = GetParam();
    const auto        cells = verification::samples(
               *verification::run("verification/elastic_plastic_piston.prm",
                                  {"Stages/piston/Mode = " + mode, "Mesh/Finest cell = 0.0025 cm"}, "piston_" + mode));
    const double elastic = 0.6520659744, plastic = 0.5505528459, v_y = 0.002957210223;
    expect_relative("piston: pressure of the elastic plateau, Mbar", mean(cells, &CellSample::pressure, 0.57, 0.63),
                    0.003646612969, 0.01);
    expect_relative("piston: velocity of the elastic plateau, cm/us", mean(cells, &CellSample::velocity, 0.57, 0.63),
                    v_y, 0.01);
    expect_relative("piston: pressure of the plastic plateau, Mbar", mean(cells, &CellSample::pressure, 0.2, 0.5),
                    0.01445554964, 0.01);
    expect_relative("piston: compression of the plastic plateau, g/cm^3",
                    mean(cells, &CellSample::density, 0.2, 0.5) - 2.79, 2.839226822 - 2.79, 0.01);
    expect_relative("piston: axial stress of the plastic plateau, Mbar", mean(cells, &CellSample::stress, 0.2, 0.5),
                    0.01445554964 + 2. / 3. * 0.0026, 0.01);
    // half-way down each front
    expect_relative("piston: speed of the plastic wave, cm/us",
                    falls_through(cells, &CellSample::velocity, 0.5 * (0.01 + v_y), 0.3), plastic, 0.01);
    expect_relative("piston: speed of the elastic wave, cm/us",
                    falls_through(cells, &CellSample::velocity, 0.5 * v_y, 0.3), elastic, 0.01);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, ScenePiston, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });
} // namespace
