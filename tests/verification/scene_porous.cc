// SPDX-License-Identifier: LGPL-2.1-or-later
// Porous piston as a whole scene, on both meshes, against the exact jump conditions of the P-alpha law.
#include "../figure.h"
#include "scene_run.h"

namespace
{
  using namespace whipple;
  using figure::expect_relative;
  using verification::CellSample;
  using verification::falls_through;
  using verification::mean;

  class ScenePorousPiston : public testing::TestWithParam<const char *>
  {
  };

  TEST_P(ScenePorousPiston, BothPlateausAndBothWaveSpeeds)
  {
    // roots of the jump conditions, tests/unit/exact_porous.cc
    const double precursor = 0.5353639746, v_e = 0.001916274024, compaction = 0.1631845398, u = 0.05, t = 15.;
    const auto   cells = verification::samples(
          *verification::run("verification/porous_piston.prm",
                             {"Stages/piston/Mode = " + std::string(GetParam()), "Mesh/Finest cell = 0.025 cm"},
                             "porous_" + std::string(GetParam())));
    // clear of the piston, whose sudden start heats the material next to it
    const double near = u * t + 0.4 * (compaction - u) * t, far = u * t + 0.85 * (compaction - u) * t;
    expect_relative("P-alpha scene: pressure, Mbar", mean(cells, &CellSample::pressure, near, far), 0.01717146658,
                    0.01);
    expect_relative("P-alpha scene: density, g/cm^3", mean(cells, &CellSample::density, near, far), 2.787676294, 0.01);
    expect_relative("P-alpha scene: compaction, cm/us",
                    falls_through(cells, &CellSample::velocity, 0.5 * (v_e + u), near) / t, compaction, 0.01);
    const double from = (compaction + 0.3 * (precursor - compaction)) * t, to = 0.9 * precursor * t;
    expect_relative("P-alpha scene: precursor pressure, Mbar", mean(cells, &CellSample::pressure, from, to), 0.002,
                    0.01);
    expect_relative("P-alpha scene: precursor, cm/us", falls_through(cells, &CellSample::velocity, 0.5 * v_e, from) / t,
                    precursor, 0.01);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, ScenePorousPiston, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });
} // namespace
