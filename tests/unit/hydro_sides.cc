// SPDX-License-Identifier: LGPL-2.1-or-later
// Sides of the domain that press, keep or prescribe.
#include "fastest_node.h"
#include "hydro_case.h"

#include <whipple/hydro/transmitting_side.h>
#include <whipple/material/ideal_gas.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  constexpr double density = 2., energy = 1.5, exponent = 1.4, gas_pressure = (exponent - 1.) * density * energy;

  std::vector<Material>
  gas()
  {
    Material material;
    material.eos = std::make_shared<IdealGas>(exponent, 1.);
    return {material};
  }

  /// A box of 8 x 8 cells of gas, its nodes shifted where nothing holds them.
  struct GasBox
  {
    GasBox(Symmetry symmetry, const Boundaries<2> &boundaries)
      : grid{symmetry, {{0., 0.}}, 0.125, {{8, 8}}, 0}
      , mesh(build(grid, uniform_keys(grid)))
      , materials(gas())
      , state(make_state(mesh, materials))
    {
      std::mt19937                           generator(1);
      std::uniform_real_distribution<double> shift(-0.03, 0.03);
      for (Index n = 0; n < mesh.n_nodes; ++n)
        for (int d = 0; d < 2; ++d)
          {
            const double s = shift(generator);
            if (ruling_side<2>(boundaries, mesh.node_side[n], d) == none && !(d == 0 && (mesh.node_side[n] & 1)))
              state.position[d][n] += s;
          }
      initialise_geometry(mesh, state);
      fill_all(state, density, energy);
    }

    double
    volume() const
    {
      return std::accumulate(state.volume.begin(), state.volume.end(), 0.);
    }

    Lattice<2>            grid;
    FlatMesh<2>           mesh;
    std::vector<Material> materials;
    State<2>              state;
  };

  /// Left side reflecting (the axis), the others a pressure.
  Boundaries<2>
  pressed(double pressure)
  {
    Boundaries<2> boundaries = sides(BoundaryKind::pressure);
    for (auto &boundary : boundaries)
      boundary.pressure = pressure;
    boundaries[0].kind = BoundaryKind::reflecting;
    return boundaries;
  }

  // A pressure acts on slanted edges and rings as the gas inside does.
  TEST(HydroSides, PressureHoldsGasOfThatPressure)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        const Boundaries<2> boundaries = pressed(gas_pressure);
        GasBox              box(symmetry, boundaries);
        LagrangeStep<2>     step(box.mesh, box.materials, boundaries, {});
        run(step, box.state, 0.5);
        EXPECT_LT(fastest_node(box.state), 1e-13);
      }
  }

  TEST(HydroSides, WorkOfThePressureIsBooked)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        const Boundaries<2> boundaries = pressed(3. * gas_pressure);
        GasBox              box(symmetry, boundaries);
        LagrangeStep<2>     step(box.mesh, box.materials, boundaries, {});
        step.update_node_mass(box.state);
        const double volume = box.volume();
        const Totals before = totals(box.state);
        const auto   report = run(step, box.state, 0.05);
        const Totals after  = totals(box.state);
        // p dV but for the difference between the positions at half step and the mean of those before and after
        const double work = 3. * gas_pressure * (volume - box.volume());
        EXPECT_GT(work, 0.1);
        EXPECT_NEAR(report.boundary_work, work, 1e-4 * work);
        EXPECT_NEAR(after.energy, before.energy + report.boundary_work, 1e-13 * before.energy);
        EXPECT_NEAR(after.momentum[1], before.momentum[1] + report.boundary_momentum[1], 1e-12);
      }
  }

  TEST(HydroSides, NodesKeepTheirVelocity)
  {
    Boundaries<2> boundaries = sides(BoundaryKind::reflecting);
    boundaries[1].kind       = BoundaryKind::keep_velocity;
    GasBox box(Symmetry::planar, boundaries);
    set_velocity(box.mesh, box.state, [](double x, double y) { return Vector<2>{{-0.5 * x, -0.1 * y * (1 - y)}}; });
    const auto      start = box.state.velocity;
    LagrangeStep<2> step(box.mesh, box.materials, boundaries, {});
    step.update_node_mass(box.state);
    const Totals before = totals(box.state);
    const auto   report = run(step, box.state, 0.2);
    for (Index n = 0; n < box.mesh.n_nodes; ++n)
      if (box.mesh.node_side[n] >> 1 & 1)
        {
          for (int d = 0; d < 2; ++d) // held at the corners of the box
            EXPECT_EQ(box.state.velocity[d][n], d == 1 && (box.mesh.node_side[n] & 12) ? 0. : start[d][n]);
        }
    EXPECT_GT(report.boundary_work, 0.1);
    EXPECT_NEAR(totals(box.state).energy, before.energy + report.boundary_work, 1e-13 * before.energy);
  }

  // Gas that expands like u = x / (1 + t): the side follows, and the density stays uniform.
  TEST(HydroSides, NodesFollowTheExactSolution)
  {
    Boundaries<2> boundaries = sides(BoundaryKind::reflecting);
    boundaries[1].kind       = BoundaryKind::exact;
    boundaries[1].motion     = [](const Vector<2> &x, double t) { return Vector<2>{{x[0] / (1. + t), 0.}}; };
    GasBox box(Symmetry::planar, boundaries);
    set_velocity(box.mesh, box.state, [](double x, double) { return Vector<2>{{x, 0.}}; });
    LagrangeStep<2> step(box.mesh, box.materials, boundaries, {});
    step.update_node_mass(box.state);
    const Totals before = totals(box.state);
    const auto   report = run(step, box.state, 0.2);
    EXPECT_NEAR(box.volume(), 1.2, 1e-3);
    for (const double rho : box.state.material[0].density)
      EXPECT_NEAR(rho, density / 1.2, 1e-3);
    EXPECT_NEAR(totals(box.state).energy, before.energy + report.boundary_work, 1e-13 * before.energy);
  }

  TEST(HydroSides, ATurnedWallHoldsTheOtherComponent)
  {
    Boundaries<2> boundaries  = sides(BoundaryKind::transmitting);
    boundaries[3].kind        = BoundaryKind::reflecting;
    boundaries[3].turned_axis = 0;
    for (const int d : {0, 1})
      EXPECT_EQ(ruling_side<2>(boundaries, 1 << 3, d), d == 0 ? 3 : none);
    boundaries[1].kind = BoundaryKind::inflow;
    EXPECT_EQ(ruling_side<2>(boundaries, 1 << 3 | 1 << 1, 0), 3); // a wall is stronger than a piston
    EXPECT_EQ(ruling_side<2>(boundaries, 1 << 3 | 1 << 1, 1), 1);
  }

  // The slope of a chord has no value where its ends meet: one round-off beside the ambient, under any stress (a trace
  // has none), it lies between the impedances of the ends.
  TEST(HydroSides, TheImpedanceIsANumberBesideTheAmbientDensity)
  {
    constexpr double ambient_density = 1.85, sound = 0.8;
    const BeyondSide ambient{0., ambient_density, ambient_density * sound};
    double           above = ambient_density;
    for (int i = 0; i < 4; ++i)
      {
        above = std::nextafter(above, 2.);
        for (const double own : {0., 0.5 * sound, 2. * sound})
          for (const double stress : {-1e-3, 0., 1e-3})
            {
              const double z = secant_impedance(ambient, stress, above, own, 0.);
              EXPECT_GE(z, std::min(ambient.impedance, above * own));
              EXPECT_LE(z, std::max(ambient.impedance, above * own));
            }
      }
    // P = rho0 c^2 (1 - rho0 / rho): a straight line in the plane of stress and volume, everywhere of slope (rho0 c)^2
    const double density = 1.1 * ambient_density, stress = ambient_density * sound * sound * (1. - 1. / 1.1);
    EXPECT_NEAR(secant_impedance(ambient, stress, density, sound, 0.), ambient.impedance, 1e-14);
  }
} // namespace
