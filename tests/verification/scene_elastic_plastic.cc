// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic and plastic fronts of the published copper piston and flying plate: plateaus and speeds within 1 %.
#include "../figure.h"
#include "scene_run.h"

namespace
{
  using namespace whipple;
  using figure::expect_relative;
  using verification::CellSample;
  using verification::falls_through;
  using verification::mean;

  /// Exact states behind both fronts, and where in the profile they are read off; cm, g, us, Mbar.
  struct Fronts
  {
    const char              *name, *scene, *mode_key;
    std::vector<std::string> overrides;
    double                   time, density; ///< of the end and at rest
    double                   yield_velocity, elastic_speed, elastic_density, elastic_pressure; ///< behind the precursor
    double                   velocity, plastic_speed, plastic_density, plastic_pressure, two_thirds_yield;
    double                   elastic_from, elastic_to, plastic_from, plastic_to; ///< plateaus
  };

  /// [Maire2013]; roots of the jump conditions by another program.
  const Fronts copper{"copper piston",
                      "verification/copper_piston.prm",
                      "Stages/piston/Mode",
                      {},
                      150.,
                      8.93,
                      4.719816e-4,
                      0.47221765,
                      8.9389345,
                      1.390301e-3,
                      2e-3,
                      0.39769475,
                      8.9734531,
                      6.81591e-3,
                      2. / 3. * 9e-4,
                      62.,
                      68.,
                      10.,
                      55.};

  /// [Wilkins1964]; roots of the jump conditions by another program.
  const Fronts wilkins{"flying plate",
                       "verification/flying_plate.prm",
                       "Stages/impact/Mode",
                       {"Mesh/Finest cell = 0.01 cm"},
                       5.,
                       2.785,
                       3.517837e-3,
                       0.6490426,
                       2.8001771,
                       4.358785e-3,
                       0.04,
                       0.5908519,
                       2.9856289,
                       0.06435879,
                       2. / 3. * 3e-3,
                       3.02,
                       3.18,
                       2.65,
                       2.85};

  class SceneFronts : public testing::TestWithParam<std::tuple<Fronts, const char *>>
  {
  };

  TEST_P(SceneFronts, PlateausAndSpeeds)
  {
    const auto &[f, mode]              = GetParam();
    std::vector<std::string> overrides = f.overrides;
    overrides.push_back(std::string(f.mode_key) + " = " + mode);
    overrides.push_back("Output/Fields interval = none");
    const auto cells = verification::samples(*verification::run(f.scene, overrides, std::string("fronts_") + mode));
    const std::string what = std::string(f.name) + ", " + mode + ": ";
    const auto elastic = [&](double CellSample::*member) { return mean(cells, member, f.elastic_from, f.elastic_to); };
    const auto plastic = [&](double CellSample::*member) { return mean(cells, member, f.plastic_from, f.plastic_to); };

    expect_relative(what + "velocity behind the elastic front, cm/us", elastic(&CellSample::velocity), f.yield_velocity,
                    0.01);
    expect_relative(what + "pressure behind the elastic front, Mbar", elastic(&CellSample::pressure),
                    f.elastic_pressure, 0.01);
    expect_relative(what + "compression behind the elastic front, g/cm^3", elastic(&CellSample::density) - f.density,
                    f.elastic_density - f.density, 0.01);
    expect_relative(what + "pressure behind the plastic front, Mbar", plastic(&CellSample::pressure),
                    f.plastic_pressure, 0.01);
    expect_relative(what + "axial stress behind the plastic front, Mbar", plastic(&CellSample::stress),
                    f.plastic_pressure + f.two_thirds_yield, 0.01);
    expect_relative(what + "compression behind the plastic front, g/cm^3", plastic(&CellSample::density) - f.density,
                    f.plastic_density - f.density, 0.01);
    expect_relative(what + "speed of the plastic front, cm/us",
                    falls_through(cells, &CellSample::velocity, 0.5 * (f.velocity + f.yield_velocity), f.plastic_from) /
                        f.time,
                    f.plastic_speed, 0.01);
    expect_relative(what + "speed of the elastic front, cm/us",
                    falls_through(cells, &CellSample::velocity, 0.5 * f.yield_velocity, f.plastic_from) / f.time,
                    f.elastic_speed, 0.01);
  }
  INSTANTIATE_TEST_SUITE_P(Cases, SceneFronts,
                           testing::Combine(testing::Values(copper, wilkins),
                                            testing::Values("eulerian", "lagrangian")),
                           [](const auto &info) {
                             std::string name = std::get<0>(info.param).name;
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name + "_" + std::get<1>(info.param);
                           });
} // namespace
