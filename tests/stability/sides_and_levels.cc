// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides of the domain, how plates are judged, and lists in another order.
#include "metals.h"
#include "stability_run.h"

#include <cmath>
#include <variant>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  /// A plate at rest, thinner than a cell, is not perforated; a dented one is not either.
  TEST(QuickPlates, AtRestIsNoHole)
  {
    Case      table("thin plate at rest", "a hole is found where nothing happened", "eulerian");
    SceneText scene = box("axisymmetric", 0, -0.32, 0.64, 0.32, 0.016, "transmitting");
    scene.set("Effects/List", "strength, voids, body tags").add("Materials", "metal", shield_aluminium());
    scene.add("Bodies", "bumper", plate(0., 0.0064, "metal"))
        .add("Stages", "s", {{"Mode", "eulerian"}, {"End", "0.1 us"}});
    const Outcome outcome = run(scene, "thin_plate");
    expect_sound(table, outcome);
    const auto &results    = outcome.summary().results.at("bumper");
    const auto  perforated = results.find("perforated");
    table.holds("not perforated",
                perforated == results.end() || !std::holds_alternative<bool>(perforated->second) ||
                    !std::get<bool>(perforated->second),
                perforated != results.end() && std::holds_alternative<bool>(perforated->second) &&
                        std::get<bool>(perforated->second)
                    ? "perforated"
                    : "no");
  }

  /// The hole of a planar impact in the middle of the whole domain is that of the half domain.
  TEST(Plates, HoleInTheWholeDomain)
  {
    Case       table("hole of a planar impact in half and whole domain",
                     "the hole is measured from the left edge of the domain", "eulerian");
    const auto hole = [](bool half) {
      SceneText scene = box("planar", half ? 0 : -1.024, -0.512, 1.024, 0.768, 0.032, "transmitting");
      if (!half)
        scene.set("Geometry/Left", "transmitting");
      scene.set("Effects/List", "strength, voids, body tags").add("Materials", "metal", shield_aluminium());
      scene.add("Bodies", "sphere", sphere(0, -0.16, 0.32, "metal", 0., 0.658))
          .add("Bodies", "bumper", plate(0., 0.081, "metal"));
      scene.add("Stages", "s", {{"Mode", "eulerian"}, {"End", "1.5 us"}});
      const Outcome outcome = run(scene, half ? "hole_half" : "hole_whole");
      const auto   &value   = outcome.summary().results.at("bumper").at("hole_diameter_cm");
      return std::holds_alternative<double>(value) ? std::get<double>(value) : -1.;
    };
    const double half = hole(true), whole = hole(false);
    table.above("hole in the half domain, cm", half, 0.32);
    table.at_most("whole against half, cells", std::abs(whole - half) / 0.032, 1.);
  }

  /// Debris leaves through a side step by step: the books must close at each.
  TEST(Leak, ThroughATransmittingSide)
  {
    Case      table("debris leaves through the sides", "a step loses energy at the side", "eulerian");
    SceneText scene = box("axisymmetric", 0, -0.512, 0.512, 0.512, 0.032, "transmitting");
    scene.set("Effects/List", "strength, voids, body tags")
        .add("Materials", "striker", shield_aluminium())
        .add("Materials", "plate", metal("tantalum"));
    scene.add("Bodies", "sphere", sphere(0, -0.16, 0.32, "striker", 0., 0.3))
        .add("Bodies", "bumper", plate(0., 0.081, "plate"));
    scene.add("Stages", "s", {{"Mode", "eulerian"}, {"End", "6 us"}});
    const Outcome outcome = run(scene, "leak");
    expect_sound_impact(table, outcome);
    double     step   = 0;
    const auto energy = outcome.statistics["energy closure"];
    for (std::size_t i = 1; i < energy.size(); ++i)
      step = std::max(step, std::abs(energy[i] - energy[i - 1]));
    table.at_most("largest change of the closure of energy in a step", step, 1e-13);
    table.above("mass that left, g", outcome.ledger().left().mass, 0.);
  }

  /// Copper and aluminium in small blocks on a plate, materials listed in either order.
  TEST(Lists, OrderOfMaterialsDoesNotSetTheStep)
  {
    Case       table("blocks of two alloys on a plate of a third, lists in both orders",
                     "a trace sets the time step in one order", "eulerian");
    const auto steps = [&](bool reversed) {
      SceneText                      scene = box("axisymmetric", 0, -0.64, 0.96, 0.32, 0.032, "transmitting");
      const std::vector<std::string> names{"aluminium 2024-T4", "aluminium 7075-T6", "aluminium 1100-O"};
      scene.set("Effects/List", "strength, voids");
      for (int i = 0; i < 3; ++i)
        scene.add("Materials", names[reversed ? 2 - i : i], metal(names[reversed ? 2 - i : i]));
      for (int i = 0; i < 12; ++i)
        {
          const double r = 0.1 * (i % 4) + 0.03 * (i / 4), z = -0.55 + 0.15 * (i / 4) + 0.01 * (i % 4);
          scene.add("Bodies", "d" + std::to_string(i),
                    block(r, z, r + 0.05, z + 0.05, names[i % 2 ? 0 : 2], 0., 0.43 + 0.01 * (i / 4)));
        }
      scene.add("Bodies", "wall", plate(0., 0.128, names[1]))
          .add("Stages", "s", {{"Mode", "eulerian"}, {"End", "3 us"}});
      const Outcome outcome = run(scene, reversed ? "lists_reversed" : "lists");
      expect_sound_impact(table, outcome);
      return outcome.steps();
    };
    const double one = steps(false), other = steps(true);
    table.within("steps in one order over the other", one / other, 1., 0.05);
  }
} // namespace
