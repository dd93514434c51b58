// SPDX-License-Identifier: LGPL-2.1-or-later
// Impacts over the whole range of speeds, thicknesses, materials and angles.
#include "metals.h"
#include "stability_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <ostream>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  struct PlaneImpact
  {
    const char *name, *striker, *target;
    double      speed; ///< km/s
    double      cells; ///< across the striker
  };

  void
  PrintTo(const PlaneImpact &impact, std::ostream *text)
  {
    *text << impact.name;
  }

  Entries
  fluid(const std::string &library)
  {
    if (library == "nylon 6/6")
      return {{"Library", library}, {"Equation of state", "cubic mie-grueneisen"}};
    return {{"Library", library}};
  }

  /// A flyer of so many cells on a target twice as thick, without strength, until the shock is halfway through the
  /// flyer.
  void
  expect_impedance_match(const PlaneImpact &impact, const std::string &mode)
  {
    const double thickness = 0.25, cell = thickness / impact.cells, speed = 0.1 * impact.speed;
    char         text[160];
    std::snprintf(text, sizeof text, "plane impact, %s on %s at %g km/s, flyer of %g cells", impact.striker,
                  impact.target, impact.speed, impact.cells);
    Case      table(text, "wrong state behind the shocks, kinetic energy from nowhere", mode);
    SceneText scene = box("planar", 0, -0.75, 2. * cell, 1.5, cell, "transmitting");
    scene.set("Geometry/Right", "reflecting")
        .add("Materials", "striker", fluid(impact.striker))
        .add("Materials", "target", fluid(impact.target));
    scene.add("Bodies", "flyer", plate(-thickness, thickness, "striker", speed))
        .add("Bodies", "target", plate(0., 2. * thickness, "target"));
    scene.add("Stages", "impact", {{"Mode", mode}, {"End", "1 us"}});
    const std::string folder = std::string("plane_") + impact.name + "_" + mode;
    std::filesystem::create_directories("stability_output/" + folder);
    scene.write("stability_output/" + folder + "/first.prm");
    const Problem<2>     read  = read_problem<2>("stability_output/" + folder + "/first.prm");
    const ImpedanceMatch match = impedance_match(read.materials[0], read.materials[1], speed);
    const double         jump  = speed - match.velocity; // in the flyer
    const double         shock = match.pressure / (read.materials[0].model.eos->reference_density() * jump);
    const double         end   = 0.8 * thickness / shock;
    scene.set("Stages/impact/End", with_unit(end, "us"));
    const Outcome outcome = run(scene, folder);
    expect_sound_impact(table, outcome);
    if (impact.cells < 16)
      return;
    double load = 0, volume = 0, momentum = 0, mass = 0;
    for (const Cell &s : outcome.cells())
      if (std::abs(s.x[1] - match.velocity * end) < 0.1 * thickness)
        {
          load += s.pressure * s.volume;
          volume += s.volume;
          momentum += s.mass * s.velocity;
          mass += s.mass;
        }
    table.within("pressure at the contact, Mbar", load / volume, match.pressure, 0.01);
    table.within("velocity of the contact, cm/us", momentum / mass, match.velocity, 0.01);
  }

  const auto plane_name = [](const auto &info) {
    return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param);
  };

  class QuickPlaneImpact : public testing::TestWithParam<std::tuple<PlaneImpact, const char *>>
  {
  };
  TEST_P(QuickPlaneImpact, ImpedanceMatch)
  {
    expect_impedance_match(std::get<0>(GetParam()), std::get<1>(GetParam()));
  }
  const char *const al = "aluminium 2024-T4", *const cu = "copper OFHC", *const ta = "tantalum",
                    *const ny = "nylon 6/6", *const st = "stainless steel 304", *const pb = "lead";
  INSTANTIATE_TEST_SUITE_P(
      Speeds, QuickPlaneImpact,
      testing::Combine(testing::Values(PlaneImpact{"al_al_0_1", al, al, 0.1, 32}, PlaneImpact{"al_al_7", al, al, 7, 32},
                                       PlaneImpact{"al_al_40", al, al, 40, 32}, PlaneImpact{"cu_al_2", cu, al, 2, 32},
                                       PlaneImpact{"al_ta_10", al, ta, 10, 32},
                                       PlaneImpact{"nylon_al_5", ny, al, 5, 32}),
                       testing::Values("eulerian", "lagrangian")),
      plane_name);

  class PlaneImpacts : public testing::TestWithParam<std::tuple<PlaneImpact, const char *>>
  {
  };
  TEST_P(PlaneImpacts, ImpedanceMatch)
  {
    expect_impedance_match(std::get<0>(GetParam()), std::get<1>(GetParam()));
  }
  INSTANTIATE_TEST_SUITE_P(
      More, PlaneImpacts,
      testing::Combine(testing::Values(PlaneImpact{"al_al_0_5", al, al, 0.5, 32}, PlaneImpact{"al_al_1", al, al, 1, 32},
                                       PlaneImpact{"al_al_2", al, al, 2, 32}, PlaneImpact{"al_al_20", al, al, 20, 32},
                                       PlaneImpact{"st_al_7", st, al, 7, 32}, PlaneImpact{"ta_al_20", ta, al, 20, 32},
                                       PlaneImpact{"pb_al_3", pb, al, 3, 32}, PlaneImpact{"al_nylon_3", al, ny, 3, 32},
                                       PlaneImpact{"nylon_nylon_2", ny, ny, 2, 32},
                                       PlaneImpact{"cu_cu_40", cu, cu, 40, 32}, PlaneImpact{"cells_1", al, al, 7, 1},
                                       PlaneImpact{"cells_2", al, al, 7, 2}, PlaneImpact{"cells_16", al, al, 7, 16},
                                       PlaneImpact{"cells_4", al, al, 7, 4}, PlaneImpact{"cells_8", al, al, 7, 8}),
                       testing::Values("eulerian", "lagrangian")),
      plane_name);

  INSTANTIATE_TEST_SUITE_P(OffTheLines, PlaneImpacts,
                           testing::Combine(testing::Values(PlaneImpact{"cells_2_5", al, al, 7, 2.5},
                                                            PlaneImpact{"cells_20", al, al, 7, 20}),
                                            testing::Values("eulerian")),
                           plane_name);

  struct SphereImpact
  {
    const char *name, *striker, *target;
    double      speed;     ///< km/s
    double      thickness; ///< of the plate, in diameters
    double      degrees;   ///< from the plate's normal; not 0: a cylinder, planar
  };

  void
  PrintTo(const SphereImpact &impact, std::ostream *text)
  {
    *text << impact.name;
  }

  /// Strength and voids in both bodies, a chain of a fixed and a moving mesh behind.
  void
  expect_sound_sphere(const SphereImpact &impact)
  {
    const double d = 0.32, cell = d / 10., speed = 0.1 * impact.speed, t = impact.thickness * d;
    const bool   oblique = impact.degrees > 0;
    char         text[160];
    std::snprintf(text, sizeof text, "%s of %s on %s at %g km/s, t/d = %g%s", oblique ? "cylinder" : "sphere",
                  impact.striker, impact.target, impact.speed, impact.thickness,
                  oblique ? (", " + std::to_string(static_cast<int>(impact.degrees)) + " degrees").c_str() : "");
    Case         table(text, "does not end, kinetic energy grows, ledger open", "eulerian, lagrangian");
    const double angle = impact.degrees * std::numbers::pi / 180., x = oblique ? 1.5 * d : 0.;
    SceneText    scene =
        box(oblique ? "planar" : "axisymmetric", 0, -1.4 * d, oblique ? 5. * d : 2. * d, 4. * d, cell, "transmitting");
    if (oblique)
      scene.set("Geometry/Left", "transmitting");
    scene.set("Effects/List", "strength, voids, body tags")
        .add("Materials", "striker", metal(impact.striker))
        .add("Materials", "plate", metal(impact.target));
    scene.add("Bodies", "striker", sphere(x, -0.5 * d, d, "striker", speed * std::sin(angle), speed * std::cos(angle)));
    scene.add("Bodies", "plate", plate(0., t, "plate"));
    const double first = std::min(4. * (d + t) / std::max(speed, 0.1), 12. * d), second = first;
    scene.add("Stages", "impact", {{"Mode", "eulerian"}, {"End", with_unit(first, "us")}});
    scene.add("Stages", "flight",
              {{"Mode", "lagrangian"},
               {"Cohesion", "fragments"},
               {"Minimum axial velocity", "0 %"},
               {"End", "for " + with_unit(second, "us")}});
    expect_sound_impact(table, run(scene, std::string("sphere_") + impact.name));
  }

  const auto sphere_name = [](const auto &info) { return std::string(info.param.name); };

  class QuickSphereImpact : public testing::TestWithParam<SphereImpact>
  {
  };
  TEST_P(QuickSphereImpact, FinishesClosedAndBounded)
  {
    expect_sound_sphere(GetParam());
  }
  INSTANTIATE_TEST_SUITE_P(Few, QuickSphereImpact,
                           testing::Values(SphereImpact{"al_al_7_thin", al, al, 7, 0.1, 0},
                                           SphereImpact{"al_al_1", al, al, 1, 0.25, 0},
                                           SphereImpact{"cu_al_20", cu, al, 20, 0.5, 0},
                                           SphereImpact{"oblique_45", al, al, 5, 0.25, 45}),
                           sphere_name);

  class SphereImpacts : public testing::TestWithParam<SphereImpact>
  {
  };
  TEST_P(SphereImpacts, FinishesClosedAndBounded)
  {
    expect_sound_sphere(GetParam());
  }
  INSTANTIATE_TEST_SUITE_P(
      Many, SphereImpacts,
      testing::Values(SphereImpact{"al_0_1_foil", al, al, 0.1, 0.01, 0},
                      SphereImpact{"al_0_1_thick", al, al, 0.1, 2, 0}, SphereImpact{"al_0_5", al, al, 0.5, 0.25, 0},
                      SphereImpact{"al_2", al, al, 2, 0.1, 0}, SphereImpact{"al_7_foil", al, al, 7, 0.01, 0},
                      SphereImpact{"al_7_half", al, al, 7, 0.5, 0}, SphereImpact{"al_7_thick", al, al, 7, 2, 0},
                      SphereImpact{"al_20", al, al, 20, 0.25, 0}, SphereImpact{"al_40_foil", al, al, 40, 0.01, 0},
                      SphereImpact{"al_40", al, al, 40, 0.25, 0}, SphereImpact{"al_40_thick", al, al, 40, 2, 0},
                      SphereImpact{"ta_al_7", ta, al, 7, 0.25, 0}, SphereImpact{"al_ta_7", al, ta, 7, 0.25, 0},
                      SphereImpact{"pb_cu_3", pb, cu, 3, 0.5, 0}, SphereImpact{"st_al_12", st, al, 12, 0.1, 0},
                      SphereImpact{"oblique_10", al, al, 5, 0.25, 10}, SphereImpact{"oblique_20", al, al, 5, 0.25, 20},
                      SphereImpact{"oblique_30", al, al, 7, 0.25, 30},
                      SphereImpact{"oblique_45_slow", al, al, 1, 0.25, 45},
                      SphereImpact{"oblique_60", al, al, 5, 0.25, 60}, SphereImpact{"oblique_70", al, al, 7, 0.25, 70}),
      sphere_name);
} // namespace
