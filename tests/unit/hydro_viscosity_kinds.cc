// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../figure.h"
#include "hydro_case.h"

#include <whipple/hydro/tensor_viscosity.h>
#include <whipple/material/ideal_gas.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  constexpr std::array<ViscosityKind, 2> kinds{{ViscosityKind::scalar, ViscosityKind::tensor}};

  std::vector<Material>
  gas()
  {
    Material material;
    material.eos = std::make_shared<IdealGas>(5. / 3., 1.);
    return {material};
  }

  HydroParameters
  with(ViscosityKind kind)
  {
    HydroParameters parameters;
    parameters.viscosity = kind;
    return parameters;
  }

  /// A mesh with hanging nodes, its inner nodes moved by up to a seventh of the finest cell.
  struct Case
  {
    Lattice<2>            grid;
    FlatMesh<2>           mesh;
    std::vector<Material> materials = gas();
    State<2>              state;
    std::mt19937          random{11};

    explicit Case(Symmetry symmetry)
      : grid{symmetry, {{0., -0.3}}, 0.05, {{6, 7}}, 1}
      , mesh(build(grid, two_level_keys(grid, [](int i, int j) { return i > 1 && i < 4 && j > 1 && j < 5; })))
      , state(make_state(mesh, materials))
    {
      std::uniform_real_distribution<double> shift(-0.007, 0.007);
      for (Index node = 0; node < mesh.n_nodes; ++node)
        for (auto &component : state.position)
          component[node] += mesh.node_side[node] == 0 ? shift(random) : 0.;
      constrain(mesh, state.position);
      initialise_geometry(mesh, state);
      fill_all(state, 1., 0.1);
    }

    /// One step in which nothing but the viscosity acts.
    LagrangeSums<2>
    viscous_step(ViscosityKind kind, const std::function<Vector<2>(double, double)> &velocity)
    {
      set_velocity(mesh, state, velocity);
      HydroParameters parameters = with(kind);
      parameters.hourglass       = 0.;
      LagrangeStep<2> step(mesh, materials, sides(BoundaryKind::keep_velocity), parameters);
      step.update_node_mass(state);
      return advance(step, state, 1e-3);
    }
  };

  TEST(ViscosityKinds, MassMomentumAndEnergyAreKept)
  {
    figure::Largest change("scalar and tensor viscosity, 20 random steps: momentum, energy, relative change",
                           "<= 1e-13");
    for (const ViscosityKind kind : kinds)
      for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
        {
          Case                                   c(symmetry);
          std::uniform_real_distribution<double> unit(-1., 1.);
          set_velocity(c.mesh, c.state, [&](double, double) {
            return Vector<2>{{0.3 * unit(c.random), 0.3 * unit(c.random)}};
          });
          LagrangeStep<2> step(c.mesh, c.materials, sides(BoundaryKind::transmitting), with(kind));
          step.update_node_mass(c.state);
          double viscous = 0;
          for (int i = 0; i < 20; ++i)
            {
              const Totals before = totals(c.state);
              const auto   report = advance(step, c.state, time_step(step, c.state).dt);
              const Totals after  = totals(c.state);
              change((after.energy - report.boundary_work) / before.energy - 1.);
              change((after.momentum[1] - report.boundary_momentum[1] - before.momentum[1]) / before.momentum_size[1]);
              EXPECT_EQ(after.mass, before.mass);
              EXPECT_NEAR(after.energy - report.boundary_work, before.energy, 1e-13 * before.energy);
              EXPECT_NEAR(after.momentum[1] - report.boundary_momentum[1], before.momentum[1],
                          1e-13 * before.momentum_size[1]);
              if (symmetry == Symmetry::planar)
                {
                  EXPECT_NEAR(after.momentum[0] - report.boundary_momentum[0], before.momentum[0],
                              1e-13 * before.momentum_size[0]);
                }
              viscous += report.viscous_work;
            }
          EXPECT_GT(viscous, 0.);
        }
  }

  TEST(ViscosityKinds, NothingInExpansionAndRigidRotation)
  {
    for (const ViscosityKind kind : kinds)
      {
        for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
          EXPECT_EQ(Case(symmetry)
                        .viscous_step(kind,
                                      [](double x, double y) {
                                        return Vector<2>{{0.5 * x, 0.2 * y}};
                                      })
                        .viscous_work,
                    0.);
        // the kinetic energy is 0.1; in the second term of the viscosity round-off is not squared
        EXPECT_NEAR(Case(Symmetry::planar)
                        .viscous_step(kind,
                                      [](double x, double y) {
                                        return Vector<2>{{-2. * y, 2. * x}};
                                      })
                        .viscous_work,
                    0., 1e-30);
      }
  }

  TEST(ViscosityKinds, NothingInsideUniformCompression)
  {
    for (const ViscosityKind kind : kinds)
      for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
        {
          Case       c(symmetry);
          const auto report = c.viscous_step(kind, [](double x, double y) { return Vector<2>{{-0.5 * x, -0.5 * y}}; });
          // given velocities are mirrored at the sides (a = 1), so not even the outermost cells feel it
          EXPECT_NEAR(report.viscous_work, 0., 1e-17);
        }
  }

  TEST(ViscosityKinds, APlaneShockAlongTheMeshFeelsAllKindsAlike)
  {
    const Lattice<2>      grid{Symmetry::planar, {{0., 0.}}, 0.1, {{20, 3}}, 0};
    const FlatMesh<2>     mesh      = build(grid, uniform_keys(grid));
    std::vector<Material> materials = gas();
    std::vector<State<2>> results;
    for (const ViscosityKind kind : kinds)
      {
        State<2> state = make_state(mesh, materials);
        fill_all(state, 1., 1e-6);
        set_velocity(mesh, state, [](double x, double) { return Vector<2>{{x == 0. ? 0. : -1., 0.}}; });
        Boundaries<2> boundaries = sides(BoundaryKind::reflecting);
        boundaries[1].kind       = BoundaryKind::keep_velocity;
        LagrangeStep<2> step(mesh, materials, boundaries, with(kind));
        run(step, state, 0.3);
        results.push_back(state);
      }
    double densest = 0;
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        densest = std::max(densest, results[0].material[0].density[cell]);
        for (const State<2> &other : results)
          EXPECT_NEAR(other.material[0].density[cell], results[0].material[0].density[cell], 1e-11);
      }
    EXPECT_GT(densest, 3.); // there is a shock: 4 behind it
  }

  /// Corners of the square [0, h]^2.
  CornerVectors<2>
  square(double h)
  {
    return {{{{0., h, 0., h}}, {{0., 0., h, h}}}};
  }

  /// Stress of a square in a velocity field v = G x, without neighbours.
  viscosity::PlaneStress<double>
  stress_of(const std::array<std::array<double, 2>, 2> &g, double h = 0.1)
  {
    const auto       x = square(h);
    CornerVectors<2> v;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 2; ++i)
        v[i][k] = g[i][0] * x[0][k] + g[i][1] * x[1][k];
    const auto gradient = velocity_gradient<2>(CellGeometry<2, Symmetry::planar>::volume_gradient(x),
                                               CellGeometry<2, Symmetry::planar>::hoop_weight(x),
                                               CellGeometry<2, Symmetry::planar>::volume(x), v);
    return viscosity::tensor_stress<double>({}, x, gradient, 2., 0.5, {{0., 0.}});
  }

  TEST(TensorViscosity, ActsOnlyAlongTheCompression)
  {
    const HydroParameters p;
    const double          h = 0.1, rate = 3., jump = rate * h;
    const double          q     = 2. * jump * (p.quadratic_viscosity * jump + p.linear_viscosity * 0.5);
    const auto            along = stress_of({{{{-rate, 0.}}, {{0., 0.}}}});
    EXPECT_NEAR(along.s00, -q, 1e-15);
    EXPECT_NEAR(along.s11, 0., 1e-15);
    EXPECT_NEAR(along.s01, 0., 1e-15);

    // the same wave along the diagonal of the square
    const auto diagonal = stress_of({{{{-0.5 * rate, -0.5 * rate}}, {{-0.5 * rate, -0.5 * rate}}}});
    EXPECT_NEAR(diagonal.s00, -0.5 * q, 1e-15);
    EXPECT_NEAR(diagonal.s11, -0.5 * q, 1e-15);
    EXPECT_NEAR(diagonal.s01, -0.5 * q, 1e-15);
  }

  TEST(TensorViscosity, ShearIsNoShock)
  {
    const auto stress = stress_of({{{{0., 5.}}, {{0., 0.}}}});
    EXPECT_EQ(stress.s00, 0.);
    EXPECT_EQ(stress.s11, 0.);
    EXPECT_EQ(stress.s01, 0.);
  }
} // namespace
