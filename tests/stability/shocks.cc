// SPDX-License-Identifier: LGPL-2.1-or-later
// Strong shocks on meshes that tempt them: implosions, a skew mesh, odd and even rows, the axis.
#include "../source_directory.h"
#include "metals.h"
#include "stability_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ostream>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  std::string
  verification_scene(const std::string &name)
  {
    return source_directory() + "/prm/verification/" + name + ".prm";
  }

  /// Hourglass work over the internal energy at the end.
  double
  hourglass_share(const Outcome &outcome)
  {
    return std::abs(outcome.statistics["hourglass work"].back()) / outcome.statistics["internal energy"].back();
  }

  /// Means of the density between two distances from the origin within 10 degrees of the axis, of 45 degrees, of the
  /// equator.
  std::array<double, 3>
  three_directions(const Outcome &outcome, double low, double high)
  {
    std::array<double, 3> mass{}, volume{};
    for (const Cell &s : outcome.cells())
      for (int i = 0; i < 3; ++i)
        {
          const double r = std::hypot(s.x[0], s.x[1]);
          if (r < low || r > high || std::abs(std::atan2(s.x[0], s.x[1]) * 180. / std::numbers::pi - 45. * i) > 10.)
            continue;
          mass[i] += s.mass;
          volume[i] += s.volume;
        }
    return {{mass[0] / volume[0], mass[1] / volume[1], mass[2] / volume[2]}};
  }

  struct Noh
  {
    const char *name, *scene, *mode, *cell;
    bool        quadrant; ///< planar scene, implosion onto the origin
    bool        bounded;  ///< fine enough for a bound on roundness
  };
  void
  PrintTo(const Noh &noh, std::ostream *text)
  {
    *text << noh.name;
  }

  void
  expect_noh(const Noh &noh)
  {
    const std::string what = noh.quadrant ? "cylindrical, in a planar quadrant" : std::string(noh.scene).substr(4);
    Case table("Noh, " + what + ", cells of " + noh.cell, "carbuncle at the axis, hourglass motion, folded cells",
               noh.mode);
    std::vector<std::string> overrides{std::string("Mesh/Finest cell = ") + noh.cell,
                                       std::string("Stages/infall/Mode = ") + noh.mode};
    if (noh.quadrant)
      for (const char *more : {"Geometry/Symmetry = planar", "Exact solution/Geometry = cylindrical"})
        overrides.push_back(more);
    const Outcome outcome = run_file(verification_scene(noh.scene), std::string("noh_") + noh.name, overrides);
    expect_sound(table, outcome);
    table.above("smallest energy, Mbar cm^3/g", outcome.smallest(&MaterialState::energy), -1e-14);
    table.at_most("hourglass work / internal energy", hourglass_share(outcome), 0.01);
    if (noh.quadrant || std::string(noh.scene) == "noh_spherical")
      {
        // between the core that the wall heats and the shock at 0.2 cm
        const auto density = three_directions(outcome, 0.09, 0.16);
        for (const int i : {0, 2})
          {
            const std::string label = std::string("density behind the shock along axis ") + (i == 0 ? "1" : "0") +
                                      " over that at 45 degrees, less 1";
            const double off = std::abs(density[i] / density[1] - 1.);
            if (noh.bounded)
              table.at_most_short(label, off, 0.05, std::string(noh.name) == "spherical_l" ? 0.07 : 0.05);
            else
              table.report(label, off);
          }
      }
    table.report("L1 error of the density, relative",
                 *outcome.summary().errors.at("density").l1 / *outcome.summary().errors.at("density").scale);
  }

  const auto noh_name = [](const auto &info) { return std::string(info.param.name); };
  class QuickNoh : public testing::TestWithParam<Noh>
  {
  };
  TEST_P(QuickNoh, SoundAndWithoutHourglass)
  {
    expect_noh(GetParam());
  }
  INSTANTIATE_TEST_SUITE_P(Coarse, QuickNoh,
                           testing::Values(Noh{"planar_e", "noh_planar", "eulerian", "0.02 cm", false, false},
                                           Noh{"planar_l", "noh_planar", "lagrangian", "0.02 cm", false, false},
                                           Noh{"cylindrical_e", "noh_cylindrical", "eulerian", "0.02 cm", false, false},
                                           Noh{"cylindrical_l", "noh_cylindrical", "lagrangian", "0.02 cm", false,
                                               false},
                                           Noh{"spherical_e", "noh_spherical", "eulerian", "0.02 cm", false, false}),
                           noh_name);
  class NohFine : public testing::TestWithParam<Noh>
  {
  };
  TEST_P(NohFine, Round)
  {
    expect_noh(GetParam());
  }
  INSTANTIATE_TEST_SUITE_P(Fine, NohFine,
                           testing::Values(Noh{"spherical_e_fine", "noh_spherical", "eulerian", "0.01 cm", false, true},
                                           Noh{"spherical_l", "noh_spherical", "lagrangian", "0.02 cm", false, true},
                                           Noh{"quadrant_e", "noh_spherical", "eulerian", "0.01 cm", true, true},
                                           Noh{"quadrant_l", "noh_spherical", "lagrangian", "0.02 cm", true, true}),
                           noh_name);

  TEST(QuickSaltzman, HourglassEnergy)
  {
    Case table("Saltzman's piston on a skew mesh, cells of 0.01 cm", "the mesh folds, hourglass motion", "lagrangian");
    const Outcome outcome = run_file(verification_scene("saltzman"), "saltzman", {"Mesh/Finest cell = 0.01 cm"});
    expect_sound(table, outcome);
    table.at_most_short("hourglass work / internal energy", hourglass_share(outcome), 0.01, 0.013);
    table.report("L1 error of the density, relative",
                 *outcome.summary().errors.at("density").l1 / *outcome.summary().errors.at("density").scale);
  }

  /// Gas of sound speed 1 falls onto a wall and stops in a shock that runs at Mach 6 into it; rows are denser and
  /// thinner in turn by 1e-3 [Quirk1994].
  class QuickOddEven : public testing::TestWithParam<const char *>
  {
  };
  TEST_P(QuickOddEven, NoCarbuncle)
  {
    const std::string mode = GetParam();
    const double      k = 1.4, mach = 6., fall = 2. / (k + 1.) * (mach - 1. / mach), cell = 0.02;
    Case              table("odd and even rows at Mach 6, perturbed by 1e-3",
                            "odd-even decoupling: the shock breaks up across the channel", mode);
    SceneText         scene = box("planar", 0, 0, 0.4, 2, cell, "reflecting");
    scene.set("Geometry/Top", "keep velocity");
    scene.add("Materials", "gas",
              {{"Equation of state", "ideal gas"}, {"Density", "1 g/cm^3"}, {"Adiabatic exponent", "1.4"}});
    for (int i = 0; i < 20; ++i)
      {
        Entries row = block(cell * i, 0, cell * (i + 1), 2, "gas", 0., -fall);
        row.push_back({"Density", with_unit(1. + (i % 2 ? 1e-3 : -1e-3), "g/cm^3")});
        row.push_back({"Pressure", with_unit(1. / k, "Mbar")});
        scene.add("Bodies", "row" + std::to_string(i), row);
      }
    scene.add("Stages", "fall", {{"Mode", mode}, {"End", "0.25 us"}});
    const Outcome outcome = run(scene, "odd_even_" + mode);
    expect_sound(table, outcome);
    table.at_most("largest velocity across / velocity of the fall", outcome.fastest(0) / fall, 0.01);
    std::array<double, 20> front{};
    for (const Cell &s : outcome.cells())
      if (s.pressure > 10.)
        {
          double &z = front[std::clamp(static_cast<int>(s.x[0] / cell), 0, 19)];
          z         = std::max(z, s.x[1] + 0.5 * s.extent);
        }
    const auto [low, high] = std::minmax_element(front.begin(), front.end());
    table.at_most("front of the shock across the channel, largest difference, cells", (*high - *low) / cell, 1.01);
    table.at_most("hourglass work / internal energy", hourglass_share(outcome), 0.01);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, QuickOddEven, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  /// A thin, wide disc strikes a plate: until the release of its rim arrives the flow is plane, at the axis too.
  class QuickAxis : public testing::TestWithParam<const char *>
  {
  };
  TEST_P(QuickAxis, PlaneImpactIsPlaneAtTheAxis)
  {
    const std::string mode = GetParam();
    const double      cell = 0.02;
    Case              table("wide disc on a plate, around the axis", "a jet or a hole at the axis", mode);
    SceneText         scene = box("axisymmetric", 0, -0.3, 1, 0.5, cell, "transmitting");
    scene.set("Effects/List", "strength, voids").add("Materials", "metal", shield_aluminium());
    scene.add("Bodies", "disc", block(0, -0.2, 0.8, 0, "metal", 0., 0.6))
        .add("Bodies", "plate", plate(0., 0.3, "metal"));
    scene.add("Stages", "impact", {{"Mode", mode}, {"End", "0.2 us"}});
    const Outcome outcome = run(scene, "axis_disc_" + mode);
    expect_sound_impact(table, outcome);
    std::array<double, 4> load{}, volume{}, momentum{}, mass{};
    for (const Cell &s : outcome.cells())
      if (const int column = static_cast<int>(s.x[0] / cell); column < 4 && std::abs(s.x[1] - 0.06) < 0.07)
        {
          load[column] += s.pressure * s.volume;
          volume[column] += s.volume;
          momentum[column] += s.velocity * s.mass;
          mass[column] += s.mass;
        }
    table.within("pressure in the first column over the fourth", load[0] / volume[0] / (load[3] / volume[3]), 1., 0.05);
    table.within("velocity in the first column over the fourth", momentum[0] / mass[0] / (momentum[3] / mass[3]), 1.,
                 0.05);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, QuickAxis, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  /// A spherical cloud, aluminium of a tenth of its density, runs onto a plate, from the fixed mesh or out of a flight
  /// as elements of their own: the plate's motion at the axis against that five degrees off it (the next two columns).
  class QuickCloud : public testing::TestWithParam<const char *>
  {
  };
  TEST_P(QuickCloud, NoJetAtTheAxis)
  {
    const std::string way   = GetParam();
    const bool        flies = way != "eulerian";
    const double      cell  = 0.02;
    Case              table("spherical cloud on a plate" + (flies ? ", laid down as " + way : std::string()),
                            "a jet or a crater at the axis", flies ? "lagrangian fragments, eulerian" : "eulerian");
    SceneText         scene = box("axisymmetric", 0, -0.96, 0.8, 0.48, cell, "transmitting");
    scene.set("Effects/List", "strength, voids").add("Materials", "metal", shield_aluminium());
    scene.add("Materials", "cloud",
              {{"Library", "aluminium 2024-T4"},
               {"Void law", "p-alpha"},
               {"Initial porosity", "90 %"},
               {"Elastic crush pressure", "1 MPa"},
               {"Full compaction pressure", "100 MPa"}});
    scene.add("Bodies", "cloud", sphere(0, flies ? -0.45 : -0.35, 0.7, "cloud", 0., 0.5))
        .add("Bodies", "plate", plate(0., 0.1, "metal"));
    if (flies)
      scene.add("Stages", "flight",
                {{"Mode", "lagrangian"}, {"Introduces", "cloud"}, {"Cohesion", "fragments"}, {"End", "0.2 us"}});
    scene.add("Stages", "impact",
              {{"Mode", "eulerian"}, {"Introduces", flies ? "plate" : "cloud, plate"}, {"End", "for 1.5 us"}});
    if (flies)
      scene.set("Stages/impact/Representation", way);
    const Outcome outcome = run(scene, "axis_cloud_" + way);
    expect_sound_impact(table, outcome);
    std::array<double, 6> momentum{}, mass{};
    const MaterialState  &metal = outcome.state().material[0];
    for (Index c = 0; c < outcome.mesh().n_owned; ++c)
      if (const int column = static_cast<int>((outcome.mesh().lower[0][c] + 0.5 * cell) / cell);
          column < 6 && metal.mass[c] > 0)
        for (int k = 0; k < 4; ++k)
          {
            const double part = outcome.state().corner_weight[4 * c + k] * metal.mass[c];
            momentum[column] += part * outcome.state().velocity[1][outcome.mesh().cell_node[4 * c + k]];
            mass[column] += part;
          }
    table.at_most("velocity of the plate in the first column over the next two",
                  momentum[0] / mass[0] / ((momentum[1] + momentum[2]) / (mass[1] + mass[2])), 1.03);
    // solid pieces thin the plate where they land, so its mass there is a sample
    const char  *what  = "mass of the plate above the first column, per area, over the next two";
    const double ratio = mass[0] / ((mass[1] + mass[2]) / 8.);
    if (way == "packages")
      table.report(what, ratio);
    else
      table.within(what, ratio, 1., 0.05);
  }
  INSTANTIATE_TEST_SUITE_P(Ways, QuickCloud, testing::Values("eulerian", "distended", "packages"),
                           [](const auto &info) { return std::string(info.param); });
} // namespace
