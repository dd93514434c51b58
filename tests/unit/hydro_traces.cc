// SPDX-License-Identifier: LGPL-2.1-or-later
// Material of which a cell holds too little to have a state of its own: doc/theory/traces.md.
#include "hydro_case.h"

#include <whipple/hydro/trace.h>
#include <whipple/material/material_factory.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  Material
  gas(double density)
  {
    MaterialRequest request;
    request.name              = "gas";
    request.equation_of_state = "ideal gas";
    request.constants         = {{"Adiabatic exponent", 1.4}, {"Density", density}};
    Material material         = make_material(request);
    material.trace_density    = trace::share * density;
    return material;
  }

  Material
  aluminium()
  {
    MaterialRequest request;
    request.library        = "aluminium 2024-T4";
    Material material      = make_material(request);
    material.trace_density = trace::share * material.eos->reference_density();
    return material;
  }

  /// A strip of 20 cells of 0.01 cm between walls.
  struct Strip
  {
    explicit Strip(std::vector<Material> m)
      : materials(std::move(m))
      , state(make_state(mesh, materials))
    {
    }

    Lattice<2>            lattice{Symmetry::planar, {{0., 0.}}, 0.01, {{20, 1}}, 0};
    FlatMesh<2>           mesh       = build(lattice, uniform_keys(lattice));
    Boundaries<2>         boundaries = sides(BoundaryKind::reflecting);
    std::vector<Material> materials;
    State<2>              state;
  };

  TEST(Traces, AHotOneSetsNoTimeStepAndIsLeftAlone)
  {
    Strip strip({gas(1.)});
    fill_all(strip.state, 1., 1.);
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    const double normal = time_step(step, strip.state).dt;

    fill(strip.state, 10, 1e-6, 1e12); // a millionth of the mass, hot beyond reason
    step.update_node_mass(strip.state);
    EXPECT_EQ(evaluate(step, strip.state).material[0].pressure[10], 0.);
    EXPECT_EQ(time_step(step, strip.state).dt, normal);
    const Totals before = totals(strip.state);
    for (int i = 0; i < 5; ++i) // until its neighbours have squeezed it to a density that has a state
      advance(step, strip.state, 0.02 * normal);
    EXPECT_EQ(strip.state.material[0].energy[10], 1e12);
    EXPECT_NEAR(totals(strip.state).energy, before.energy, 1e-13 * before.energy);
    // all of three times that mass has a state again
    fill(strip.state, 10, 3e-6, 1.);
    EXPECT_GT(evaluate(step, strip.state).material[0].pressure[10], 0.);
  }

  TEST(Traces, GasBesideExpandingMetalDoesNotThinWithoutBound)
  {
    Strip strip({aluminium(), gas(0.0141)});
    for (Index cell = 0; cell < strip.mesh.n_cells; ++cell)
      {
        const double share = cell == 7 ? 1e-9 : 0.;
        fill(strip.state, cell, 2.785, 0., 0, 1. - share);
        if (share > 0)
          fill(strip.state, cell, 0.0141, 0.05, 1, share);
      }
    set_velocity(strip.mesh, strip.state, [](double x, double) { return Vector<2>{{0.1 * (x - 0.1), 0.}}; });
    strip.boundaries = sides(BoundaryKind::keep_velocity);
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    const double mass = strip.state.material[1].mass[7];
    for (int i = 0; i < 2000; ++i)
      advance(step, strip.state, std::min(0.005, time_step(step, strip.state).dt));
    EXPECT_EQ(strip.state.material[1].mass[7], mass);
    EXPECT_NEAR(strip.state.material[1].density[7], 0.0141, 1e-12);
    EXPECT_LT(std::abs(strip.state.material[1].energy[7]), 1.);
    EXPECT_TRUE(std::isfinite(strip.state.material[0].energy[7]));
  }

  TEST(Traces, AloneItsDensityHasAFloor)
  {
    Strip strip({gas(1.)});
    fill_all(strip.state, 1.9e-6, 1.);
    set_velocity(strip.mesh, strip.state, [](double x, double) { return Vector<2>{{x, 0.}}; });
    strip.boundaries = sides(BoundaryKind::keep_velocity);
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    for (int i = 0; i < 500; ++i)
      advance(step, strip.state, 0.01);
    for (Index cell = 0; cell < strip.mesh.n_cells; ++cell)
      {
        EXPECT_NEAR(strip.state.material[0].density[cell], 1.9e-6, 1e-18);
        EXPECT_LE(strip.state.material[0].volume[cell], strip.state.volume[cell]);
        EXPECT_EQ(strip.state.material[0].energy[cell], 1.);
      }
  }

  /// On a fixed mesh a cell may be pressed in every step and be filled up with void by the remap, for ever.
  TEST(Traces, AloneItIsNotPressedBeyondItsNormalDensity)
  {
    Strip strip({aluminium()});
    fill(strip.state, 10, 2.785, 0.01, 0, 1e-7);
    LagrangeStep<2>           step(strip.mesh, strip.materials, strip.boundaries, {});
    const std::vector<double> whole = strip.state.volume;
    const double              mass  = strip.state.material[0].mass[10];
    strip.state.material[0].volume[10] *= 1e3; // as dust
    strip.state.material[0].density[10] /= 1e3;
    for (int i = 0; i < 3000; ++i)
      {
        strip.state.position = strip.mesh.node_point;
        strip.state.volume   = whole;
        step.update_node_mass(strip.state);
        set_velocity(strip.mesh, strip.state, [](double x, double) { return Vector<2>{{0.1 - x, 0.}}; });
        advance(step, strip.state, 0.01);
      }
    EXPECT_EQ(strip.state.material[0].mass[10], mass);
    EXPECT_NEAR(strip.state.material[0].density[10], 2.785, 1e-12);
    EXPECT_NEAR(strip.state.material[0].volume[10], 1e-7 * whole[10], 1e-19);
    EXPECT_EQ(strip.state.material[0].energy[10], 0.01);
  }

  TEST(TimeStep, KnowsWhatASideIsAboutToDo)
  {
    Strip strip({aluminium()});
    fill_all(strip.state, 2.785, 0.);
    strip.boundaries[0].kind     = BoundaryKind::inflow;
    strip.boundaries[0].velocity = {{2., 0.}};
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    const TimeStepLimit limit = time_step(step, strip.state);
    EXPECT_LE(limit.dt, 0.1 * 0.01 / 2.); // a tenth of the cell's volume
    EXPECT_EQ(limit.cell, 0);
  }

  TEST(TimeStep, MatterWithoutSoundStillFliesApart)
  {
    // a law whose c^2 < 0 at this state, with a pressure: ice of Tillotson between the phases
    MaterialRequest request;
    request.name              = "ice";
    request.equation_of_state = "tillotson";
    request.constants         = {{"Density", 0.917},
                                 {"Tillotson hot Grueneisen coefficient", 0.3},
                                 {"Tillotson cold Grueneisen coefficient", 0.1},
                                 {"Tillotson bulk modulus", 0.0947},
                                 {"Tillotson quadratic modulus", 0.0947},
                                 {"Tillotson reference energy", 0.1},
                                 {"Tillotson incipient vaporisation energy", 0.00773},
                                 {"Tillotson complete vaporisation energy", 0.0304},
                                 {"Tillotson thermal decay", 10.},
                                 {"Tillotson cohesive decay", 5.}};
    Strip strip({make_material(request)});
    fill_all(strip.state, 0.7336, 0.0303);
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    ASSERT_EQ(evaluate(step, strip.state).material[0].sound_speed[3], 0.);
    const double pressure = evaluate(step, strip.state).material[0].pressure[3];
    ASSERT_GT(pressure, 0.001);
    EXPECT_NEAR(time_step(step, strip.state).dt, 0.5 * 0.01 / std::sqrt(pressure / 0.7336), 1e-12);
  }

  TEST(TimeStep, AStepThatChangesAVolumeByHalfFails)
  {
    Strip strip({aluminium()});
    fill_all(strip.state, 2.785, 0.);
    set_velocity(strip.mesh, strip.state, [](double x, double) { return Vector<2>{{x < 0.095 ? 0.01 : -0.01, 0.}}; });
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    const State<2> before = strip.state;
    EXPECT_THROW(advance(step, strip.state, 0.3), StateError);
    EXPECT_EQ(strip.state.volume, before.volume);
    EXPECT_EQ(strip.state.material[0].energy, before.material[0].energy);
  }

  TEST(TimeStep, NoStateBeyondTheLawsPoleIsAccepted)
  {
    Strip        strip({aluminium()});
    const double pole = strip.materials[0].eos->max_density();
    ASSERT_LT(pole, 20.);
    fill_all(strip.state, 0.9 * pole, 10.);
    set_velocity(strip.mesh, strip.state, [](double x, double) { return Vector<2>{{-40. * (x - 0.1), 0.}}; });
    strip.boundaries = sides(BoundaryKind::keep_velocity);
    LagrangeStep<2> step(strip.mesh, strip.materials, strip.boundaries, {});
    step.update_node_mass(strip.state);
    EXPECT_THROW(advance(step, strip.state, 0.005), StateError);
    EXPECT_NO_THROW(advance(step, strip.state, 1e-5));
  }
} // namespace
