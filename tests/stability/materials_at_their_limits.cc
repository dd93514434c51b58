// SPDX-License-Identifier: LGPL-2.1-or-later
// Void laws from soft to infinitely stiff, equations of state where they end, and matter that sets the clock.
#include "metals.h"
#include "stability_run.h"

#include <whipple/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  /// Volume of pores at the end over the volume of all material.
  double
  pores(const Outcome &outcome)
  {
    double sum = 0, volume = 0;
    for (const MaterialState &m : outcome.state().material)
      for (Index c = 0; c < outcome.mesh().n_owned; ++c)
        if (m.mass[c] > 0)
          {
            volume += m.volume[c];
            if (m.has_voids())
              sum += m.void_fraction[c] * m.volume[c];
          }
    return sum / volume;
  }

  class QuickAlpha : public testing::TestWithParam<const char *>
  {
  };

  /// A flyer spalls a target; the two strike again later. Alpha over eleven decades, and the law of equilibrium.
  TEST_P(QuickAlpha, SameStepsAndALimit)
  {
    const std::string mode = GetParam();
    Case              table("spall and recompaction, alpha = 1e-2 ... 1e9 us/cm^2 and infinite",
                            "a stiff void law sets the time step or does not converge", mode);
    double            closure = 0, growth = 0, last = 0, limit = 0;
    long              fewest = std::numeric_limits<long>::max(), most = 0;
    bool              finish = true;
    for (const char *alpha : {"1e-2 us/cm^2", "1 us/cm^2", "1e3 us/cm^2", "1e6 us/cm^2", "1e9 us/cm^2", "infinite"})
      {
        SceneText scene = box("planar", 0, -0.2, 0.02, 0.5, 0.01, "transmitting");
        scene.set("Geometry/Right", "reflecting")
            .set("Effects/List", "voids")
            .add("Materials", "metal",
                 {{"Library", "aluminium 2024-T4"},
                  {"Void law", "rate"},
                  {"Alpha", alpha},
                  {"Spall strength", "0.5 GPa"}});
        scene.add("Bodies", "flyer", plate(-0.1, 0.1, "metal", 0.05)).add("Bodies", "target", plate(0., 0.2, "metal"));
        scene.add("Stages", "impact", {{"Mode", mode}, {"End", "1.5 us"}});
        const Outcome outcome                             = run(scene, "alpha_" + mode);
        finish                                            = finish && !outcome.stopped;
        closure                                           = std::max(closure, outcome.closure());
        growth                                            = std::max(growth, outcome.kinetic_growth());
        fewest                                            = std::min(fewest, outcome.steps());
        most                                              = std::max(most, outcome.steps());
        (std::string(alpha) == "infinite" ? limit : last) = pores(outcome);
      }
    table.holds("finishes", finish, finish ? "yes" : "no");
    table.at_most("closure of mass, momentum, energy", closure, 1e-12);
    table.at_most("largest kinetic energy / that of the bodies, less 1", growth - 1., 1e-9);
    table.at_most("most steps / fewest", static_cast<double>(most) / fewest, 1.1);
    table.within("volume of pores at 1e9 against infinite", last, limit, 0.01);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, QuickAlpha, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  class QuickCrush : public testing::TestWithParam<const char *>
  {
  };

  /// A porous plate is crushed to solid by a flyer, then released from both sides.
  TEST_P(QuickCrush, ToNothingAndBack)
  {
    const std::string mode = GetParam();
    Case              table("P-alpha foam crushed to solid and unloaded",
                            "the work of crushing is lost, phi below 0, the step collapses at phi = 0", mode);
    SceneText         scene = box("planar", 0, -0.3, 0.02, 0.8, 0.01, "transmitting");
    scene.set("Geometry/Right", "reflecting")
        .set("Effects/List", "voids")
        .add("Materials", "metal",
             {{"Library", "aluminium 2024-T4"}, {"Void law", "equilibrium"}, {"Spall strength", "1 GPa"}});
    scene.add("Materials", "foam",
              {{"Library", "aluminium 2024-T4"},
               {"Void law", "p-alpha"},
               {"Initial porosity", "50 %"},
               {"Elastic crush pressure", "50 MPa"},
               {"Full compaction pressure", "500 MPa"}});
    scene.add("Bodies", "flyer", plate(-0.2, 0.2, "metal", 0.2)).add("Bodies", "foam", plate(0., 0.2, "foam"));
    scene.add("Stages", "impact", {{"Mode", mode}, {"End", "3 us"}});
    const Outcome outcome = run(scene, "crush_" + mode);
    expect_sound_impact(table, outcome);
    double               least = 1;
    const MaterialState &foam  = outcome.state().material[1];
    for (Index c = 0; c < outcome.mesh().n_owned; ++c)
      if (foam.mass[c] > 0)
        least = std::min(least, foam.void_fraction[c]);
    table.at_least("smallest phi", least, 0.);
    table.at_most("smallest phi of the crushed foam", least, 1e-12);
    table.at_least("smallest time step / median", outcome.smallest_step_over_median(), 0.05);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, QuickCrush, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  /// A speck of a millionth of the mass, at 40 times the energy of the impact, lies beside a plate that is struck.
  TEST(QuickClock, AHotSpeckDoesNotSetTheStep)
  {
    // of a cell it is 1e-4, above what is a trace: until it has expanded its own sound is felt
    Case table("hot speck of 1e-6 of the mass beside an impact", "one hot cell sets the time step of all", "eulerian");
    const auto scene = [](bool speck) {
      SceneText text = box("planar", 0, -0.2, 0.4, 0.3, 0.02, "transmitting");
      text.set("Effects/List", "voids")
          .add("Materials", "metal",
               {{"Library", "aluminium 2024-T4"},
                {"Void law", "rate"},
                {"Alpha", "1e5 us/cm^2"},
                {"Spall strength", "1.2 GPa"}});
      text.add("Bodies", "flyer", block(0, -0.12, 0.2, 0., "metal", 0., 0.5))
          .add("Bodies", "plate", plate(0., 0.08, "metal"));
      if (speck)
        {
          Entries hot = block(0.301, -0.0592, 0.3012, -0.059, "metal");
          hot.push_back({"Specific energy", "5 Mbar cm^3/g"});
          text.add("Bodies", "speck", hot);
        }
      return text.add("Stages", "impact", {{"Mode", "eulerian"}, {"End", "0.4 us"}});
    };
    const Outcome with = run(scene(true), "hot_speck"), without = run(scene(false), "no_speck");
    expect_sound(table, with);
    table.at_most("steps / steps without the speck", static_cast<double>(with.steps()) / without.steps(), 2.);
    table.at_least("smallest time step / median", with.smallest_step_over_median(), 0.05);
  }

  /// Gas under pressure between two plates, one of them struck.
  TEST(QuickClock, GasBetweenPlates)
  {
    Case      table("hydrogen of 20 MPa between aluminium plates, struck at 7 km/s",
                    "traces of gas thin without bound and become not a number", "eulerian");
    SceneText scene = box("axisymmetric", 0, -0.4, 0.6, 0.9, 0.025, "transmitting");
    scene.add("Materials", "metal", {{"Library", "aluminium 2024-T4"}})
        .add("Materials", "gas",
             {{"Equation of state", "ideal gas"}, {"Adiabatic exponent", "1.4"}, {"Density", "0.0141 g/cm^3"}});
    Entries gas = plate(0.1, 0.5, "gas");
    gas.push_back({"Pressure", "20 MPa"});
    scene.add("Bodies", "sphere", sphere(0, -0.16, 0.3, "metal", 0., 0.7))
        .add("Bodies", "wall", plate(0., 0.1, "metal"))
        .add("Bodies", "gas", gas)
        .add("Bodies", "rear", plate(0.6, 0.1, "metal"));
    scene.add("Stages", "impact", {{"Mode", "eulerian"}, {"End", "1 us"}});
    const Outcome outcome = run(scene, "gas_between_plates");
    expect_sound(table, outcome);
    table.at_least("smallest time step / median", outcome.smallest_step_over_median(), 0.05);
  }

  /// Tillotson's ice where its square of the sound speed is negative: it must expand in many small steps.
  class QuickIce : public testing::TestWithParam<const char *>
  {
  };
  TEST_P(QuickIce, ImaginarySoundSpeed)
  {
    const std::string mode = GetParam();
    Case              table("Tillotson ice at 0.7336 g/cm^3, 3.03 MJ/kg: c^2 < 0",
                            "one step over the whole expansion, a tension of -5 GPa", mode);
    SceneText         scene = box("planar", 0, 0, 0.1, 0.1, 0.01, "reflecting");
    scene.add("Materials", "ice",
              {{"Equation of state", "tillotson"},
               {"Density", "0.917 g/cm^3"},
               {"Tillotson hot Grueneisen coefficient", "0.3"},
               {"Tillotson cold Grueneisen coefficient", "0.1"},
               {"Tillotson bulk modulus", "9.47 GPa"},
               {"Tillotson quadratic modulus", "9.47 GPa"},
               {"Tillotson reference energy", "10 MJ/kg"},
               {"Tillotson incipient vaporisation energy", "0.773 MJ/kg"},
               {"Tillotson complete vaporisation energy", "3.04 MJ/kg"},
               {"Tillotson thermal decay", "10"},
               {"Tillotson cohesive decay", "5"}});
    Entries body = block(0, 0, 0.1, 0.05, "ice");
    body.push_back({"Density", "0.7336 g/cm^3"});
    body.push_back({"Specific energy", "3.03 MJ/kg"});
    scene.add("Bodies", "ice", body).add("Stages", "s", {{"Mode", mode}, {"End", "1 us"}});
    const Outcome outcome = run(scene, "ice_" + mode);
    expect_sound(table, outcome);
    table.at_least("steps", outcome.steps(), 20);
    table.at_least("smallest pressure, Mbar", outcome.smallest_pressure(), -0.01);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, QuickIce, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  /// Tillotson aluminium without a void law, driven apart after an impact: the thin tail between expanded states.
  TEST(Limits, TillotsonThinTail)
  {
    Case      table("Tillotson aluminium without void law, 20 km/s, cells of 0.01 cm",
                    "energies of +-20 Mbar cm^3/g in the thin tail", "eulerian");
    SceneText scene = box("planar", 0, -0.6, 0.02, 1.8, 0.01, "transmitting");
    scene.set("Geometry/Right", "reflecting")
        .add("Materials", "metal", {{"Library", "aluminium"}, {"Equation of state", "tillotson"}});
    scene.add("Bodies", "flyer", plate(-0.5, 0.5, "metal", 2.)).add("Bodies", "target", plate(0., 0.5, "metal"));
    scene.add("Stages", "impact", {{"Mode", "eulerian"}, {"End", "0.43 us"}});
    const Outcome outcome = run(scene, "tillotson_tail");
    expect_sound_impact(table, outcome);
    table.at_most("largest specific energy / kinetic of the impact", outcome.greatest(&MaterialState::energy) / 2., 1.);
    table.at_least("smallest specific energy, Mbar cm^3/g", outcome.smallest(&MaterialState::energy), -0.2);
    table.at_least("smallest time step / median", outcome.smallest_step_over_median(), 0.05);
  }

  /// Hot lead whose law, the linear polynomial, keeps Gamma gamma0 e as its pressure however far it has expanded: its
  /// sound speed grows as 1/gamma, and a run would go on with ever smaller steps.
  TEST(QuickClock, ALawWithoutAVacuum)
  {
    Case table("hot lead by the linear polynomial, in an empty box", "steps get smaller without a word", "eulerian");
    SceneText scene = box("planar", 0, 0, 0.1, 6, 0.05, "reflecting");
    scene.set("Effects/List", "voids")
        .add("Materials", "lead",
             {{"Library", "lead"},
              {"Equation of state", "linear polynomial"},
              {"Void law", "rate"},
              {"Alpha", "1 us/cm^2"}});
    Entries body = block(0, 0, 0.1, 0.1, "lead");
    body.push_back({"Specific energy", "5 MJ/kg"});
    scene.add("Bodies", "block", body).add("Stages", "s", {{"Mode", "eulerian"}, {"End", "1000 us"}});
    const Outcome outcome = run(scene, "linear_polynomial");
    const bool    named   = outcome.stopped && outcome.stopped->find("linear polynomial") != std::string::npos;
    table.holds("stops and names the law", named,
                outcome.stopped ? "stopped: " + outcome.stopped->substr(0, 120) : "ends");
    table.at_most("closure of mass, momentum, energy", outcome.closure(), 1e-12);
  }

  /// A piston of 20 km/s runs into aluminium; what stands behind the shock is the Hugoniot of the library's constants.
  TEST(QuickPiston, FirstStepKnowsIt)
  {
    Case table("piston of 20 km/s into aluminium", "the first step goes past the pole of the Hugoniot", "lagrangian");
    SceneText scene = box("planar", 0, 0, 0.02, 0.4, 0.01, "reflecting");
    scene.set("Geometry/Bottom", "inflow 0 km/s, 20 km/s")
        .add("Materials", "metal", {{"Library", "aluminium 2024-T4"}});
    scene.add("Bodies", "metal", block(0, 0, 0.02, 0.4, "metal"))
        .add("Stages", "push", {{"Mode", "lagrangian"}, {"End", "0.08 us"}});
    const Outcome        outcome = run(scene, "piston");
    const Problem<2>     read    = read_problem<2>("stability_output/piston/scene.prm");
    const ImpedanceMatch match   = impedance_match(read.materials[0], read.materials[0], 4.); // u = half the speed
    expect_sound(table, outcome);
    table.at_most("steps", outcome.steps(), 2000);
    double load = 0, volume = 0;
    for (const Cell &s : outcome.cells())
      if (s.x[1] > 0.18 && s.x[1] < 0.21)
        {
          load += s.pressure * s.volume;
          volume += s.volume;
        }
    table.within("pressure behind the shock, Mbar", load / volume, match.pressure, 0.02);
  }

  /// Gas that streams into the fixed mesh with ten times the speed of sound. Behind the shock of a piston
  /// U = (k+1)/4 u + sqrt[((k+1)/4 u)^2 + c^2], P = p0 + rho0 U u.
  TEST(QuickPiston, FasterThanSoundIntoTheFixedMesh)
  {
    Case      table("inflow at ten times the speed of sound", "the pressure is wrong by a factor of two", "eulerian");
    SceneText scene = box("planar", 0, 0, 0.04, 1, 0.02, "reflecting");
    scene.set("Geometry/Bottom", "inflow 0 cm/us, 1 cm/us");
    scene.add(
        "Materials", "gas",
        {{"Equation of state", "ideal gas"}, {"Density", "1 g/cm^3"}, {"Adiabatic exponent", "1.6666666666666667"}});
    Entries gas = block(0, 0, 0.04, 1, "gas");
    gas.push_back({"Specific energy", "1e-2 Mbar cm^3/g"});
    scene.add("Bodies", "gas", gas)
        .add("Stages", "push", {{"Mode", "eulerian"}, {"End", "0.4 us"}, {"Max time step", "0.002 us"}});
    try
      {
        const Outcome outcome = run(scene, "inflow");
        expect_sound(table, outcome);
        const double p0 = 2. / 3. * 1e-2, c = std::sqrt(5. / 3. * p0), shock = 2. / 3. + std::sqrt(4. / 9. + c * c);
        double       load = 0, volume = 0;
        for (const Cell &s : outcome.cells())
          if (s.x[1] > 0.1 && s.x[1] < 0.3)
            {
              load += s.pressure * s.volume;
              volume += s.volume;
            }
        table.within("pressure behind the shock, Mbar", load / volume, p0 + shock, 0.02);
      }
    catch (const InputError &refusal)
      {
        table.holds("right, or refused", true, std::string("refused: ") + std::string(refusal.what()).substr(0, 100));
      }
  }

  /// The same chain at any size: lengths and times scaled together, alpha with their square... per length and time.
  TEST(Limits, SameResultAtAnySize)
  {
    Case   table("sphere through a plate at sizes from 1e-4 to 1e4 cm", "totals have an absolute scale",
                 "eulerian, lagrangian, eulerian");
    double first_hole = 0, first_kinetic = 0, worst = 0, closure = 0;
    bool   finish = true;
    for (const double size : {1., 1e-4, 1e-2, 1e2, 1e4})
      {
        SceneText scene = box("axisymmetric", 0, -0.64 * size, 1.28 * size, 2.56 * size, 0.04 * size, "transmitting");
        scene.set("Effects/List", "voids, body tags")
            .add("Materials", "metal",
                 {{"Library", "aluminium 2024-T4"}, {"Void law", "equilibrium"}, {"Spall strength", "1.2 GPa"}});
        scene.add("Bodies", "sphere", sphere(0, -0.2 * size, 0.4 * size, "metal", 0., 0.6))
            .add("Bodies", "bumper", plate(0., 0.12 * size, "metal"))
            .add("Bodies", "wall", plate(2. * size, 0.12 * size, "metal"));
        scene.add("Stages", "through",
                  {{"Mode", "eulerian"}, {"Introduces", "sphere, bumper"}, {"End", with_unit(1.5 * size, "us")}});
        scene.add("Stages", "flight",
                  {{"Mode", "lagrangian"},
                   {"Cohesion", "fragments"},
                   {"Debris behind", "bumper"},
                   {"End", "for " + with_unit(1.2 * size, "us")}});
        scene.add("Stages", "wall",
                  {{"Mode", "eulerian"}, {"Introduces", "wall"}, {"End", "for " + with_unit(0.5 * size, "us")}});
        const Outcome outcome = run(scene, "size_" + with_unit(size, "cm"));
        finish                = finish && !outcome.stopped;
        closure               = std::max(closure, outcome.closure());
        const double kinetic =
            outcome.statistics["kinetic energy"].back() / outcome.ledger().introduced().kinetic_energy;
        const double mass = outcome.ledger().introduced().mass / std::pow(size, 3);
        if (size == 1.)
          {
            first_kinetic = kinetic;
            first_hole    = mass;
          }
        worst = std::max({worst, std::abs(kinetic / first_kinetic - 1.), std::abs(mass / first_hole - 1.)});
      }
    table.holds("finishes at every size", finish, finish ? "yes" : "no");
    table.at_most("closure of mass, momentum, energy", closure, 1e-12);
    table.at_most("kinetic energy at the end and mass, dimensionless: largest difference from 1 cm", worst, 1e-6);
  }

  /// Bodies whose faces or curves touch mesh lines to round-off.
  class QuickSlivers : public testing::TestWithParam<const char *>
  {
  };
  TEST_P(QuickSlivers, RoundOffIsNotPainted)
  {
    const std::string mode = GetParam();
    Case              table("sphere and plates that touch mesh lines to round-off",
                            "volume shares of 1e-15 to 1e-31 are painted: not a number", mode);
    SceneText         scene = box("axisymmetric", 0, -0.512, 0.256, 0.256, 0.016, "transmitting");
    scene.set("Effects/List", "strength, voids").add("Materials", "metal", shield_aluminium());
    scene.add("Bodies", "sphere", sphere(0, -0.16, 0.32, "metal", 0., 0.))
        .add("Bodies", "plate", plate(0., 0.048, "metal"))
        .add("Bodies", "second", plate(0.064, 3 * 0.016, "metal"));
    scene.add("Stages", "s", {{"Mode", mode}, {"End", "0.3 us"}});
    const Outcome outcome = run(scene, "slivers_" + mode);
    table.holds("finishes", !outcome.stopped, outcome.stopped ? "stopped: " + outcome.stopped->substr(0, 120) : "yes");
    table.at_most("fastest node, cm/us", outcome.fastest(), 1e-12);
    double least = 1;
    for (Index c = 0; c < outcome.mesh().n_owned; ++c)
      if (const MaterialState &m = outcome.state().material[0]; m.mass[c] > 0)
        least = std::min(least, m.volume[c] / outcome.state().volume[c]);
    table.at_least("smallest volume share of a cell with material", least, 1e-12);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, QuickSlivers, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });
} // namespace
