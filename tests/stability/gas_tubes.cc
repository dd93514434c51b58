// SPDX-License-Identifier: LGPL-2.1-or-later
// Riemann problems of gases that break schemes: fans that part, strong shocks, huge jumps, expansion into nothing.
#include "stability_run.h"

#include <whipple/exact/riemann.h>
#include <whipple/material/ideal_gas.h>

#include <cmath>
#include <ostream>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  struct GasState
  {
    double density, velocity, pressure;
  };

  struct Tube
  {
    const char *name, *what, *wrong;
    double      exponent;
    GasState    left, right;
    double      interface, end;
    double      goal; ///< L1 error of the density on 100 cells, relative to its mean, that must not be passed
  };

  void
  PrintTo(const Tube &tube, std::ostream *text)
  {
    *text << tube.name;
  }

  /// [Toro2009], section 4.3.3: tests 2 (1-2-3) and 3 (half of
  /// Woodward and Colella's blast wave, pressures 1e5 apart); [Lax1954];
  /// LeBlanc: [Loubere2005] (there on [0, 9] with t = 6, here scaled
  /// to [0, 1]).
  const Tube one_two_three{"one_two_three",
                           "1-2-3: fans that part",
                           "density or energy below zero, heating where the fans part",
                           1.4,
                           {1., -2., 0.4},
                           {1., 2., 0.4},
                           0.5,
                           0.15,
                           0.06},
      lax{"lax", "Lax's tube", "wiggles behind the contact", 1.4, {0.445, 0.698, 3.528}, {0.5, 0., 0.571}, 0.5,
          0.13,  0.035},
      blast{"blast",
            "blast, pressures 1e5 apart",
            "overshoot, negative energy at the shock",
            1.4,
            {1., 0., 1000.},
            {1., 0., 0.01},
            0.5,
            0.012,
            0.1},
      leblanc{"leblanc",
              "LeBlanc's tube, pressures 1e9 apart",
              "negative energy, a shock that runs ahead",
              5. / 3.,
              {1., 0., 2. / 30.},
              {1e-3, 0., 2. / 3. * 1e-10},
              1. / 3.,
              2. / 3.,
              0.05};

  /// The tube along axis 1 on [0, 1]; the sides let through what the gas does.
  SceneText
  tube_scene(const Tube &tube, const std::string &mode)
  {
    SceneText scene = box("planar", 0, 0, 0.02, 1, 0.01, "reflecting");
    if (tube.left.velocity > 0)
      scene.set("Geometry/Bottom", "inflow " + velocity(0., tube.left.velocity));
    if (tube.right.velocity > 0)
      for (const char *side : {"Bottom", "Top"})
        scene.set(std::string("Geometry/") + side, "transmitting");
    scene.add("Materials", "gas",
              {{"Equation of state", "ideal gas"},
               {"Density", "1 g/cm^3"},
               {"Adiabatic exponent", std::to_string(tube.exponent)}});
    for (const bool left : {true, false})
      {
        const GasState &gas = left ? tube.left : tube.right;
        scene.add("Bodies", left ? "left" : "right",
                  {{"Shape", "box"},
                   {"Lower corner", cm(0., left ? 0. : tube.interface)},
                   {"Upper corner", cm(0.02, left ? tube.interface : 1.)},
                   {"Material", "gas"},
                   {"Velocity", velocity(0., gas.velocity)},
                   {"Density", with_unit(gas.density, "g/cm^3")},
                   {"Pressure", with_unit(gas.pressure, "Mbar")}});
      }
    return scene.add("Stages", "tube", {{"Mode", mode}, {"End", with_unit(tube.end, "us")}});
  }

  exact::Riemann
  exact_solution(const Tube &tube)
  {
    const auto gas  = std::make_shared<IdealGas>(tube.exponent, 1.);
    const auto side = [&](const GasState &s) {
      return exact::Riemann::State{gas, s.density, s.velocity, s.pressure / (tube.exponent - 1.) / s.density};
    };
    return exact::Riemann(side(tube.left), side(tube.right), tube.interface);
  }

  class QuickTubes : public testing::TestWithParam<std::tuple<Tube, const char *>>
  {
  };

  TEST_P(QuickTubes, PositiveAndNearTheExactSolution)
  {
    const auto &[tube, mode] = GetParam();
    Case          table(tube.what, tube.wrong, mode);
    const Outcome outcome = run(tube_scene(tube, mode), std::string(tube.name) + "_" + mode);
    expect_sound(table, outcome);
    table.above("smallest density, g/cm^3", outcome.smallest(&MaterialState::density), 0.);
    table.above("smallest energy, Mbar cm^3/g", outcome.smallest(&MaterialState::energy), 0.);
    const exact::Riemann exact = exact_solution(tube);
    double               error = 0, norm = 0, fastest = 0, smallest = 1e300;
    for (int i = 0; i <= 1000; ++i)
      {
        const exact::ProfileState state = exact.at(i / 1000., tube.end);
        fastest                         = std::max(fastest, std::abs(state.velocity));
        smallest                        = std::min(smallest, state.density);
      }
    for (const Cell &cell : outcome.cells())
      {
        const double low = cell.x[1] - 0.5 * cell.extent, high = cell.x[1] + 0.5 * cell.extent;
        if (low < 0.02 || high > 0.98) // the sides are not part of the problem
          continue;
        const double mean = exact.mean_density((low - tube.interface) / tube.end, (high - tube.interface) / tube.end);
        error += std::abs(cell.density - mean) * cell.volume;
        norm += mean * cell.volume;
      }
    table.at_most("relative L1 error of the density", error / norm, tube.goal);
    table.report("fastest node / fastest gas", outcome.fastest() / fastest);
    table.report("smallest density / exact", outcome.smallest(&MaterialState::density) / smallest);
  }
  INSTANTIATE_TEST_SUITE_P(Gas, QuickTubes,
                           testing::Combine(testing::Values(one_two_three, lax, blast, leblanc),
                                            testing::Values("eulerian", "lagrangian")),
                           [](const auto &info) {
                             return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param);
                           });
} // namespace
