// SPDX-License-Identifier: LGPL-2.1-or-later
// The same scene mirrored, turned, shifted, or with its lists in another order is the same scene.
#include "metals.h"
#include "stability_run.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <ostream>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  constexpr double cell = 1. / 64.; // exact in binary: a shift by cells is exact, too

  /// What is done to the scene.
  struct Change
  {
    const char *name, *what;
    bool        mirrored = false, turned = false, bodies_reversed = false, materials_reversed = false;
    int         shift = 0;
    double      bound = 0; ///< largest relative difference allowed
  };

  void
  PrintTo(const Change &change, std::ostream *text)
  {
    *text << change.name;
  }

  /// A copper block strikes an aluminium block aslant; a third one touches both. All on [0, 1] x [0, 1].
  SceneText
  oblique(const Change &change, const std::string &mode)
  {
    SceneText scene = box("planar", 0, 0, 1, 1, cell, "transmitting");
    scene.set("Geometry/Left", "transmitting").set("Effects/List", "strength, voids");
    std::vector<std::pair<std::string, Entries>> materials{{"copper", metal("copper OFHC")},
                                                           {"aluminium", metal("aluminium 2024-T4")}};
    const auto moved = [&](double x0, double y0, double x1, double y1, const std::string &material, double v0,
                           double v1) {
      if (change.mirrored)
        {
          std::swap(y0, y1);
          y0 = 1. - y0;
          y1 = 1. - y1;
          v1 = -v1;
        }
      if (change.turned)
        {
          std::swap(x0, y0);
          std::swap(x1, y1);
          std::swap(v0, v1);
        }
      const double s = change.shift * cell;
      return block(x0 + s, y0 + s, x1 + s, y1 + s, material, v0, v1);
    };
    std::vector<std::pair<std::string, Entries>> bodies{{"striker", moved(0.28, 0.25, 0.45, 0.375, "copper", 0.2, 0.5)},
                                                        {"target", moved(0.25, 0.375, 0.6, 0.5, "aluminium", 0., 0.)},
                                                        {"side", moved(0.45, 0.3, 0.6, 0.375, "aluminium", 0., 0.)}};
    if (change.materials_reversed)
      std::reverse(materials.begin(), materials.end());
    if (change.bodies_reversed)
      std::reverse(bodies.begin(), bodies.end());
    for (const auto &[name, entries] : materials)
      scene.add("Materials", name, entries);
    for (const auto &[name, entries] : bodies)
      scene.add("Bodies", name, entries);
    return scene.add("Stages", "impact", {{"Mode", mode}, {"End", "0.12 us"}});
  }

  struct Values
  {
    double mass = 0, momentum_0 = 0, momentum_1 = 0, energy = 0;
  };

  /// Cell of the lattice, where it would be without the change -> mass, momentum, energy.
  std::map<std::pair<int, int>, Values>
  undone(const Outcome &outcome, const Change &change)
  {
    std::map<std::pair<int, int>, Values> result;
    const FlatMesh<2>                    &mesh  = outcome.mesh();
    const State<2>                       &state = outcome.state();
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        int i = static_cast<int>(std::lround(mesh.lower[0][c] / cell)) - change.shift,
            j = static_cast<int>(std::lround(mesh.lower[1][c] / cell)) - change.shift;
        Values v;
        for (const MaterialState &m : state.material)
          {
            v.mass += m.mass[c];
            v.energy += m.mass[c] * m.energy[c];
          }
        if (!(v.mass > 0))
          continue;
        for (int k = 0; k < 4; ++k)
          {
            const Index n = mesh.cell_node[4 * c + k];
            v.momentum_0 += 0.25 * v.mass * state.velocity[0][n];
            v.momentum_1 += 0.25 * v.mass * state.velocity[1][n];
          }
        if (change.turned)
          {
            std::swap(i, j);
            std::swap(v.momentum_0, v.momentum_1);
          }
        if (change.mirrored)
          {
            j            = 63 - j;
            v.momentum_1 = -v.momentum_1;
          }
        result[{i, j}] = v;
      }
    return result;
  }

  class QuickInvariance : public testing::TestWithParam<std::tuple<Change, const char *>>
  {
  };

  TEST_P(QuickInvariance, SameScene)
  {
    const auto &[change, mode] = GetParam();
    Case          table(std::string("oblique impact of copper on aluminium, ") + change.what,
                        "results depend on direction, place or order", mode);
    const Change  nothing{"", ""};
    const Outcome plain = run(oblique(nothing, mode), std::string("invariance_plain_") + change.name + "_" + mode),
                  other = run(oblique(change, mode), std::string("invariance_") + change.name + "_" + mode);
    expect_sound_impact(table, plain);
    expect_sound_impact(table, other);
    const auto a = undone(plain, nothing), b = undone(other, change);
    Values     scale, difference;
    for (const auto &[key, v] : a)
      {
        scale.mass       = std::max(scale.mass, v.mass);
        scale.energy     = std::max(scale.energy, std::abs(v.energy));
        scale.momentum_0 = std::max({scale.momentum_0, std::abs(v.momentum_0), std::abs(v.momentum_1)});
      }
    std::map<std::pair<int, int>, Values> all = a;
    all.insert(b.begin(), b.end());
    bool bits = true;
    for (const auto &[key, unused] : all)
      {
        const auto   found_a = a.find(key), found_b = b.find(key);
        const Values va = found_a == a.end() ? Values{} : found_a->second,
                     vb = found_b == b.end() ? Values{} : found_b->second;
        bits            = bits && va.mass == vb.mass && va.energy == vb.energy && va.momentum_0 == vb.momentum_0 &&
               va.momentum_1 == vb.momentum_1;
        difference.mass   = std::max(difference.mass, std::abs(va.mass - vb.mass) / scale.mass);
        difference.energy = std::max(difference.energy, std::abs(va.energy - vb.energy) / scale.energy);
        difference.momentum_0 =
            std::max({difference.momentum_0, std::abs(va.momentum_0 - vb.momentum_0) / scale.momentum_0,
                      std::abs(va.momentum_1 - vb.momentum_1) / scale.momentum_0});
      }
    const double largest = std::max({difference.mass, difference.energy, difference.momentum_0});
    if (std::string(change.name) == "materials" && std::string(mode) == "eulerian")
      table.at_most_short("largest difference of mass, momentum, energy in a cell, relative to the largest of all",
                          largest, change.bound, 0.3);
    else if (change.bound > 0)
      table.at_most("largest difference of mass, momentum, energy in a cell, relative to the largest of all", largest,
                    change.bound);
    else
      table.holds("same bits", bits, bits ? "yes" : "differ by " + std::to_string(largest));
    table.holds("same number of steps", plain.steps() == other.steps(),
                std::to_string(plain.steps()) + ", " + std::to_string(other.steps()));
  }

  // Sums over the four corners of a cell and over the materials run in the order of their numbers, so what changes that
  // order (a mirror, a turn, materials in another order) changes the last bits, and so does a shift, through the
  // coordinates. Where little of a material is in a cell its density and energy are quotients of small differences:
  // that makes 1e-9 of 1e-16. A turn also changes which axis the remap sweeps first: on the fixed mesh that is a
  // difference of the scheme, not of round-off.
  INSTANTIATE_TEST_SUITE_P(
      Changes, QuickInvariance,
      testing::Combine(
          testing::Values(Change{"bodies", "bodies listed in another order", false, false, true, false, 0, 0.},
                          Change{"materials", "materials listed in another order", false, false, false, true, 0, 1e-10},
                          Change{"mirrored", "mirrored", true, false, false, false, 0, 1e-8},
                          Change{"shifted", "shifted by one cell", false, false, false, false, 1, 1e-8}),
          testing::Values("eulerian", "lagrangian")),
      [](const auto &info) { return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param); });
  INSTANTIATE_TEST_SUITE_P(
      Turned, QuickInvariance,
      testing::Combine(testing::Values(Change{"turned", "turned by 90 degrees", false, true, false, false, 0, 1e-10}),
                       testing::Values("lagrangian")),
      [](const auto &info) { return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param); });

  /// Half a planar domain with a symmetry plane is the whole domain.
  class QuickSymmetryPlane : public testing::TestWithParam<const char *>
  {
  };
  TEST_P(QuickSymmetryPlane, HalfIsTheWhole)
  {
    const std::string mode = GetParam();
    Case              table("hot gas in cold gas, half and whole domain", "first order at the symmetry plane", mode);
    const auto        scene = [&](bool half) {
      SceneText    text = box("planar", half ? 0 : -1, -0.5, 1, 0.5, 0.0625, "reflecting");
      const double left = half ? 0 : -1;
      text.add("Materials", "gas",
                      {{"Equation of state", "ideal gas"}, {"Density", "1 g/cm^3"}, {"Adiabatic exponent", "1.4"}});
      const auto part = [&](const char *name, double x0, double y0, double x1, double y1, const char *pressure) {
        Entries body = block(x0, y0, x1, y1, "gas");
        body.push_back({"Pressure", pressure});
        text.add("Bodies", name, body);
      };
      part("below", left, -0.5, 1, 0, "0.1 Mbar");
      part("hot", half ? 0 : -0.25, 0, 0.25, 0.25, "10 Mbar");
      part("right", 0.25, 0, 1, 0.25, "0.1 Mbar");
      if (!half)
        part("left", -1, 0, -0.25, 0.25, "0.1 Mbar");
      part("above", left, 0.25, 1, 0.5, "0.1 Mbar");
      return text.add("Stages", "s", {{"Mode", mode}, {"End", "0.15 us"}});
    };
    const Outcome half = run(scene(true), "symmetry_half_" + mode), whole = run(scene(false), "symmetry_whole_" + mode);
    expect_sound(table, half);
    std::map<std::pair<int, int>, double> energy;
    const auto                            key = [&](const Outcome &o, Index c) {
      return std::pair(static_cast<int>(std::lround(o.mesh().lower[0][c] / 0.0625)),
                                                  static_cast<int>(std::lround(o.mesh().lower[1][c] / 0.0625)));
    };
    for (Index c = 0; c < half.mesh().n_owned; ++c)
      energy[key(half, c)] = half.state().material[0].energy[c];
    double difference = 0, largest = 0;
    for (Index c = 0; c < whole.mesh().n_owned; ++c)
      if (const auto found = energy.find(key(whole, c)); found != energy.end())
        {
          difference = std::max(difference, std::abs(whole.state().material[0].energy[c] - found->second));
          largest    = std::max(largest, found->second);
        }
    table.at_most("largest difference of the specific energy / largest", difference / largest, 1e-11);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, QuickSymmetryPlane, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });
} // namespace
