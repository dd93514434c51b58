// SPDX-License-Identifier: LGPL-2.1-or-later
// Whole scenes with what single materials do: plastic flow, spall, melting on release.
#include "../figure.h"
#include "scene_run.h"

#include <whipple/exact/isentrope.h>
#include <whipple/exact/uniaxial_loading.h>
#include <whipple/material/solid_liquid_vapour.h>

#include <numbers>
#include <variant>

namespace
{
  using namespace whipple;
  using figure::expect_at_most;
  using figure::expect_relative;
  using verification::run;

  /// Length of a rod along the axis and its radius at the foot, z = 0: of a moving mesh from the nodes, of a fixed one
  /// from the volume in the column of cells on the axis and in the lowest row.
  struct Rod
  {
    double length = 0, foot = 0; // cm
  };

  Rod
  measure_rod(const Simulation<2> &simulation, bool lagrangian)
  {
    const FlatMesh<2> &mesh  = simulation.domain().view->mesh;
    const State<2>    &state = simulation.domain().state;
    Rod                rod;
    if (lagrangian)
      {
        for (Index node = 0; node < mesh.n_nodes; ++node)
          {
            rod.length = std::max(rod.length, state.position[1][node]);
            if (state.position[1][node] < 1e-9)
              rod.foot = std::max(rod.foot, state.position[0][node]);
          }
        return rod;
      }
    double row = 0;
    for (Index cell = 0; cell < mesh.n_owned; ++cell)
      {
        const double volume = state.material[0].volume[cell] / std::numbers::pi, size = mesh.size[cell];
        if (mesh.lower[0][cell] == 0.)
          rod.length += volume / (size * size);
        if (mesh.lower[1][cell] == 0.)
          row += volume / size;
      }
    rod.foot = std::sqrt(row);
    return rod;
  }

  class SceneTaylorBar : public testing::TestWithParam<const char *>
  {
  };

  TEST_P(SceneTaylorBar, LengthFootAndPlasticWork)
  {
    const std::string mode = GetParam();
    const auto        simulation =
        run("verification/copper_taylor_bar.prm",
            {"Stages/impact/Mode = " + mode, "Mesh/Finest cell = 0.04 cm", "Output/Fields interval = none"},
            "taylor_" + mode);
    // the band of published codes [TaylorBar], and 3 % about it
    const Rod         rod  = measure_rod(*simulation, mode == "lagrangian");
    const std::string what = "copper Taylor bar, " + mode + ": ";
    figure::record(what + "length, cm", rod.length, "2.142 ... 2.147, 3 % about it");
    EXPECT_GT(rod.length, 0.97 * 2.142);
    EXPECT_LT(rod.length, 1.03 * 2.147);
    figure::record(what + "radius of the foot, cm", rod.foot, "0.697 ... 0.718, 3 % about it");
    EXPECT_GT(rod.foot, 0.97 * 0.697);
    EXPECT_LT(rod.foot, 1.03 * 0.718);

    const auto  &ledger  = simulation->summary().ledger.energy;
    const double lost    = ledger.extra.at("initial_kinetic") - ledger.extra.at("kinetic");
    const double plastic = ledger.extra.at("plastic_work") / lost;
    figure::record(what + "plastic work / kinetic energy lost", plastic, "0.95 ... 1");
    EXPECT_GT(plastic, 0.95);
    EXPECT_LT(plastic, 1.);
    expect_at_most(what + "energy balance", *ledger.closure_relative, 1e-12);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, SceneTaylorBar, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  class SceneSpall : public testing::TestWithParam<const char *>
  {
  };

  TEST_P(SceneSpall, PlaneIsWhereTheReleasesMeet)
  {
    const std::string mode = GetParam();
    const auto        simulation =
        run("verification/spall.prm", {"Stages/impact/Mode = " + mode, "Stages/impact/End = 1.1 us"}, "spall_" + mode);
    const FlatMesh<2> &mesh     = simulation->domain().view->mesh;
    const State<2>    &state    = simulation->domain().state;
    const auto        &material = state.material[0];
    double             voids = 0, moment = 0;
    for (Index cell = 0; cell < mesh.n_owned; ++cell)
      {
        const double volume = material.volume[cell] * material.void_fraction[cell];
        double       z      = 0;
        for (int k = 0; k < 4; ++k)
          z += 0.25 * state.position[1][mesh.cell_node[4 * cell + k]];
        voids += volume;
        moment += volume * z;
      }
    ASSERT_GT(voids, 0.);
    // When it opens, 2 mm below the free face of 5 mm; the material there has moved by V h / c until then. Later, on a
    // fixed mesh, the remap spreads voids into sound neighbours: doc/theory/voids.md.
    expect_at_most("spall, " + mode + ": distance of the voids from the spall plane, cells",
                   (moment / voids - 0.3 - 0.001 * 0.2 / 0.6491) / 0.005, 1.);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, SceneSpall, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });

  /// Share of the mass that is molten after a symmetric impact of aluminium and release to zero pressure: from the
  /// scene.
  double
  melt_share(double speed, const std::string &mode)
  {
    const auto simulation = run("verification/melt_on_release.prm",
                                {"Stages/impact/Mode = " + mode, "Output/Fields interval = none",
                                 "Bodies/flyer/Velocity = 0 cm/us, " + std::to_string(speed) + " cm/us"},
                                "melt_" + mode);
    return std::get<double>(simulation->summary().results.at("impact").at("melt_share"));
  }

  /// The same by Hugoniot and isentrope of the equation of state.
  double
  melt_share(double speed)
  {
    Material   aluminium;
    const auto eos        = std::make_shared<SolidLiquidVapour>();
    aluminium.eos         = eos;
    const auto    shocked = exact::UniaxialLoading(aluminium, eos->reference_density(), 0.).fronts(0.5 * speed).back();
    const auto    start   = exact::fluid_point(*eos, shocked.behind.density, shocked.behind.energy);
    const auto    end     = exact::Isentrope(eos, start).at_pressure(0.).fluid;
    double        share   = 0;
    ThermalOutput output;
    output.melt_fraction = {&share, 1};
    static_cast<const ThermalModel &>(*eos).evaluate({&end.density, 1}, {&end.energy, 1}, output);
    return share;
  }

  class SceneMelting : public testing::TestWithParam<const char *>
  {
  };

  TEST_P(SceneMelting, OnsetAndEndOnRelease)
  {
    const std::string mode = GetParam(), what = "melt on release, " + mode + ": ";
    // the molten share is nearly linear in the speed between its ends
    const double low = melt_share(0.58, mode), middle = melt_share(0.62, mode), high = melt_share(0.67, mode);
    // short of 3 % on the fixed mesh: cells at the contact start hotter since a gap no longer resists before it has
    // closed
    const double onset = 0.62 - middle / (middle - low) * 0.04;
    expect_relative(what + "onset, cm/us", onset, 0.55, mode == "eulerian" ? 0.04 : 0.03);
    const double complete = 0.67 + (1. - high) / (high - middle) * 0.05;
    figure::record(what + "complete, cm/us", complete,
                   "near 0.66; SHORT of it, equation of state alone: 0.705 within 2 %");
    EXPECT_NEAR(complete, 0.705, 0.02 * 0.705);
    // at the contact and at the faces a few of the 160 cells start too hot
    expect_at_most(what + "share at 5 km/s", melt_share(0.5, mode), 0.05);
    expect_at_most(what + "share at 6.2 km/s, less that of Hugoniot and isentrope", middle - melt_share(0.62), 0.05);
    expect_relative(what + "share at 7.5 km/s", melt_share(0.75, mode), 1., 0.02);
  }
  INSTANTIATE_TEST_SUITE_P(Modes, SceneMelting, testing::Values("eulerian", "lagrangian"),
                           [](const auto &info) { return std::string(info.param); });
} // namespace
