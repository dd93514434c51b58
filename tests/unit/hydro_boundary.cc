// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hydro_case.h"

#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  std::vector<Material>
  aluminium()
  {
    Material material;
    material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.785, 0.5328, 1.338, 2.});
    material.strength = std::make_shared<PerfectlyPlastic>(0.276, 0.003);
    return {material};
  }

  /// A strip of 100 cells, 1 cm long, whose upper end is transmitting.
  struct OpenStrip
  {
    OpenStrip()
      : grid{Symmetry::planar, {{0., 0.}}, 0.01, {{100, 1}}, 0}
      , mesh(build(grid, uniform_keys(grid)))
      , boundaries(sides(BoundaryKind::reflecting))
      , materials(aluminium())
      , state(make_state(mesh, materials))
    {
      boundaries[1].kind = BoundaryKind::transmitting;
      fill_all(state, 2.785, 0.);
    }

    Lattice<2>            grid;
    FlatMesh<2>           mesh;
    Boundaries<2>         boundaries;
    std::vector<Material> materials;
    State<2>              state;
  };

  TEST(HydroBoundary, PlateAtRestStaysAtRest)
  {
    OpenStrip       strip;
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    run(step, strip.state, 1.);
    for (const double v : strip.state.velocity[0])
      EXPECT_EQ(v, 0.);
  }

  TEST(HydroBoundary, UnstressedMaterialLeavesUnbraked)
  {
    OpenStrip strip;
    strip.boundaries[0].kind = BoundaryKind::transmitting;
    set_velocity(strip.mesh, strip.state, [](double, double) { return Vector<2>{{0.3, 0.}}; });
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    run(step, strip.state, 1.);
    for (const double v : strip.state.velocity[0])
      EXPECT_NEAR(v, 0.3, 1e-12);
  }

  TEST(HydroBoundary, ElasticPulseIsAbsorbed)
  {
    // a smooth pulse that runs to the right; 2 us later it would be back from a free or fixed end
    OpenStrip    strip;
    const double speed = std::sqrt(0.5328 * 0.5328 + 4. / 3. * 0.276 / 2.785), peak = 1e-5;
    const auto   pulse = [peak](double x) { return peak * std::exp(-std::pow((x - 0.5) / 0.1, 2)); };
    set_velocity(strip.mesh, strip.state, [&](double x, double) { return Vector<2>{{pulse(x), 0.}}; });
    for (Index cell = 0; cell < strip.mesh.n_cells; ++cell)
      {
        const double strain = pulse(strip.mesh.lower[0][cell] + 0.005) / speed;
        fill(strip.state, cell, 2.785 * (1. + strain), 0.);
        strip.state.material[0].fields[0].value[cell] = -4. / 3. * 0.276 * strain;
        strip.state.material[0].fields[1].value[cell] = 2. / 3. * 0.276 * strain;
      }
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    const double before = totals(strip.state).energy;
    const auto   report = run(step, strip.state, 1.5);
    double       left   = 0;
    for (const double v : strip.state.velocity[0])
      left = std::max(left, std::abs(v));
    std::printf("  reflected share of the pulse: %.3f\n", left / peak);
    EXPECT_LT(left, 0.1 * peak);
    EXPECT_LT(report.boundary_work, 0.);
    EXPECT_NEAR(totals(strip.state).energy - report.boundary_work, before, 1e-13 * before);
  }

  TEST(HydroBoundary, TimeStepNamesItsReason)
  {
    OpenStrip       strip;
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    const double longitudinal = std::sqrt(0.5328 * 0.5328 + 4. / 3. * 0.276 / 2.785);
    EXPECT_EQ(time_step(step, strip.state).reason, "sound");
    EXPECT_NEAR(time_step(step, strip.state).dt, 0.5 * 0.01 / longitudinal, 1e-12);
    strip.state.velocity[0][strip.mesh.cell_node[4 * 50 + 1]] = -1.;
    strip.state.velocity[0][strip.mesh.cell_node[4 * 50 + 3]] = -1.;
    EXPECT_EQ(time_step(step, strip.state).reason, "viscosity");
    EXPECT_EQ(time_step(step, strip.state).cell, 50);
    set_velocity(strip.mesh, strip.state, [](double x, double) { return Vector<2>{{40. * x, 0.}}; });
    EXPECT_EQ(time_step(step, strip.state).reason, "volume change");
    EXPECT_NEAR(time_step(step, strip.state).dt, 0.1 / 40., 1e-12);
  }
} // namespace
