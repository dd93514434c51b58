// SPDX-License-Identifier: LGPL-2.1-or-later
#include "figure.h"
#include "scene_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

// Strong shocks into cold gas on a fixed mesh: the remap may not pay for the kinetic energy of its slopes with heat
// that the gas ahead does not have. No floor is set anywhere.

namespace
{
  using namespace whipple;

  double
  coldest(const Simulation<2> &simulation)
  {
    const State<2> &state = simulation.domain().state;
    double          least = std::numeric_limits<double>::infinity();
    for (const MaterialState &m : state.material)
      for (std::size_t c = 0; c < m.mass.size(); ++c)
        if (m.mass[c] > 0)
          least = std::min(least, m.energy[c]);
    return least;
  }

  void
  expect_positive(const std::string &what, const std::vector<std::string> &overrides, const double ahead)
  {
    auto all = overrides;
    all.insert(all.end(), {"Stages/tube/Mode = eulerian", "Output/Fields interval = none"});
    const auto   simulation = verification::run("verification/sod.prm", all, "cold_gas");
    const double share      = coldest(*simulation) / ahead;
    figure::record(what + ": least specific energy over that of the gas ahead", share, "> 0.5");
    EXPECT_GT(share, 0.5) << what;
    EXPECT_LT(*simulation->summary().ledger.energy.closure_relative, 1e-12);
  }
} // namespace

TEST(SceneColdGas, StrongShocksLeaveItsEnergyPositive)
{
  for (const std::string low : {"0.01", "1e-7"})
    expect_positive("ratio of pressures 1000 : " + low,
                    {"Mesh/Finest cell = 0.005 cm", "Bodies/high/Pressure = 1000 Mbar",
                     "Bodies/low/Pressure = " + low + " Mbar", "Bodies/low/Density = 1 g/cm^3",
                     "Stages/tube/End = 0.012 us"},
                    std::stod(low) / 0.4);
  expect_positive("LeBlanc",
                  {"Mesh/Finest cell = 0.005 cm", "Materials/gas/Adiabatic exponent = 1.6666666666666667",
                   "Bodies/high/Pressure = 0.0666666666666667 Mbar", "Bodies/low/Pressure = 6.66666666666667e-11 Mbar",
                   "Bodies/low/Density = 1e-3 g/cm^3", "Stages/tube/End = 0.5 us"},
                  1e-7);
}

TEST(SceneColdGas, SpheresOfColdGasThatCollapseStayCold)
{
  // Noh's gas has no heat at all until the shock comes
  const auto simulation = verification::run(
      "verification/noh_spherical.prm",
      {"Stages/infall/Mode = eulerian", "Mesh/Finest cell = 0.04 cm", "Output/Fields interval = none"}, "cold_noh");
  const double least = coldest(*simulation);
  figure::record("spherical Noh, fixed mesh: least specific energy, Mbar cm3/g", least, ">= -1e-16");
  EXPECT_GE(least, -1e-16); // round-off of v^2
}
