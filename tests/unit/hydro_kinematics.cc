// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../figure.h"
#include "hydro_case.h"

#include <whipple/hydro/hourglass.h>
#include <whipple/hydro/velocity_gradient.h>
#include <whipple/material/ideal_gas.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  std::vector<Material>
  gas()
  {
    Material material;
    material.eos = std::make_shared<IdealGas>(5. / 3., 1.);
    return {material};
  }

  Lattice<2>
  lattice(Symmetry symmetry)
  {
    return {symmetry, {{0., -0.3}}, 0.05, {{6, 7}}, 1};
  }

  FlatMesh<2>
  mesh_with_hanging_nodes(Symmetry symmetry)
  {
    const Lattice<2> grid = lattice(symmetry);
    return build(grid, two_level_keys(grid, [](int i, int j) { return i > 1 && i < 4 && j > 1 && j < 5; }));
  }

  /// Nodes inside moved by up to a seventh of the finest cell.
  void
  distort(const FlatMesh<2> &mesh, State<2> &state)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> shift(-0.007, 0.007);
    for (Index node = 0; node < mesh.n_nodes; ++node)
      for (auto &component : state.position)
        component[node] += mesh.node_side[node] == 0 ? shift(random) : 0.;
    constrain(mesh, state.position);
    initialise_geometry(mesh, state);
  }

  CornerVectors<2>
  corners(const FlatMesh<2> &mesh, const std::array<std::vector<double>, 2> &field, Index cell)
  {
    CornerVectors<2> value;
    for (int k = 0; k < 4; ++k)
      for (int d = 0; d < 2; ++d)
        value[d][k] = field[d][mesh.cell_node[cell * 4 + k]];
    return value;
  }

  template <Symmetry symmetry>
  VelocityGradient<2, double>
  gradient_of(const CornerVectors<2> &x, const CornerVectors<2> &v)
  {
    return velocity_gradient<2>(CellGeometry<2, symmetry>::volume_gradient(x),
                                CellGeometry<2, symmetry>::hoop_weight(x), CellGeometry<2, symmetry>::volume(x), v);
  }

  TEST(HydroKinematics, LinearVelocityIsSeenExactlyAndWithoutHourglass)
  {
    const FlatMesh<2> mesh  = mesh_with_hanging_nodes(Symmetry::axisymmetric);
    State<2>          state = make_state(mesh, gas());
    distort(mesh, state);
    set_velocity(mesh, state, [](double r, double z) { return Vector<2>{{0.3 * r, 0.2 - 0.7 * z + 0.4 * r}}; });
    figure::Largest difference("v_r = a r: relative difference of radial and hoop rate", "round-off");
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        const CornerVectors<2> x = corners(mesh, state.position, cell), v = corners(mesh, state.velocity, cell);
        const auto             gradient = gradient_of<Symmetry::axisymmetric>(x, v);
        difference(gradient.hoop / gradient.l[0][0] - 1.);
        EXPECT_NEAR(gradient.hoop, 0.3, 1e-13);
        EXPECT_NEAR(gradient.l[0][0], 0.3, 1e-13);
        EXPECT_NEAR(gradient.l[0][1], 0., 1e-13);
        EXPECT_NEAR(gradient.l[1][0], 0.4, 1e-13);
        EXPECT_NEAR(gradient.l[1][1], -0.7, 1e-13);
        const std::array<double, 2> shape{hourglass::moment(x[0]), hourglass::moment(x[1])};
        for (const double rate : hourglass::velocity(shape, gradient, v))
          EXPECT_NEAR(rate, 0., 1e-15);
      }
  }

  /// One step from a velocity field that stretches `directions` axes at `rate`, 1/us, with pressures that vanish
  /// at half step.
  LagrangeSums<2>
  work_of(Symmetry symmetry, double rate, int directions, const std::function<Vector<2>(double, double)> &velocity,
          State<2> &state)
  {
    const FlatMesh<2>           mesh      = mesh_with_hanging_nodes(symmetry);
    const std::vector<Material> materials = gas();
    state                                 = make_state(mesh, materials);
    distort(mesh, state);
    fill_all(state, 1., 0.);
    set_velocity(mesh, state, velocity);
    Boundaries<2>   boundaries = sides(BoundaryKind::transmitting);
    LagrangeStep<2> step(mesh, materials, boundaries, {});
    step.update_node_mass(state);
    constexpr double dt = 1e-3;
    // sound without pressure: whatever moves a node or heats a cell is viscosity or hourglass resistance
    Derived derived = evaluate(step, state);
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        derived.material[0].pressure[cell]    = 0.5 * dt * directions * rate / (1. + 0.5 * dt * rate);
        derived.material[0].sound_speed[cell] = 1.;
      }
    return step.advance(state, derived, dt);
  }

  TEST(HydroKinematics, RadialExpansionFeelsNoForce)
  {
    State<2>   state;
    const auto report = work_of(
        Symmetry::axisymmetric, 0.5, 2,
        [](double r, double) {
          return Vector<2>{{0.5 * r, 0.}};
        },
        state);
    EXPECT_EQ(report.viscous_work, 0.);
    EXPECT_NEAR(report.hourglass_work, 0., 1e-26);
    for (const double e : state.material[0].energy)
      EXPECT_NEAR(e, 0., 1e-16);
  }

  TEST(HydroKinematics, RigidRotationHasNoStrainRateViscosityOrHourglass)
  {
    const auto rotation = [](double x, double y) { return Vector<2>{{-2. * y, 2. * x}}; };
    State<2>   state;
    const auto report = work_of(Symmetry::planar, 0., 0, rotation, state);
    EXPECT_EQ(report.viscous_work, 0.);
    EXPECT_NEAR(report.hourglass_work, 0., 1e-26);
    const FlatMesh<2> mesh = mesh_with_hanging_nodes(Symmetry::planar);
    set_velocity(mesh, state, rotation);
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        const auto gradient =
            gradient_of<Symmetry::planar>(corners(mesh, state.position, cell), corners(mesh, state.velocity, cell));
        EXPECT_NEAR(gradient.l[0][0], 0., 1e-13);
        EXPECT_NEAR(gradient.l[1][1], 0., 1e-13);
        EXPECT_NEAR(gradient.l[0][1] + gradient.l[1][0], 0., 1e-13);
        EXPECT_NEAR(gradient.l[1][0], 2., 1e-13);
      }
  }

  TEST(HydroKinematics, UniformCompressionHasNoViscosityInside)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        State<2> state;
        work_of(
            symmetry, -0.5, symmetry == Symmetry::planar ? 2 : 3,
            [](double x, double y) {
              return Vector<2>{{-0.5 * x, -0.5 * y}};
            },
            state);
        const FlatMesh<2> mesh   = mesh_with_hanging_nodes(symmetry);
        int               inside = 0;
        for (Index cell = 0; cell < mesh.n_cells; ++cell)
          {
            bool outer = false;
            for (int side = 0; side < 4; ++side)
              outer = outer || mesh.faces[side / 2].side[mesh.cell_face[side][cell * 2]] >= 0;
            if (outer)
              EXPECT_GT(state.material[0].energy[cell], 0.);
            else
              {
                EXPECT_NEAR(state.material[0].energy[cell], 0., 1e-15);
                ++inside;
              }
          }
        EXPECT_GT(inside, 10);
      }
  }

  TEST(HydroKinematics, CompressionAgainstAWallIsMirrored)
  {
    const FlatMesh<2>           mesh      = mesh_with_hanging_nodes(Symmetry::planar);
    const std::vector<Material> materials = gas();
    State<2>                    state     = make_state(mesh, materials);
    fill_all(state, 1., 0.);
    set_velocity(mesh, state, [](double x, double) { return Vector<2>{{-0.5 * x, 0.}}; });
    LagrangeStep<2> step(mesh, materials, sides(BoundaryKind::reflecting), {});
    step.update_node_mass(state);
    advance(step, state, 1e-3);
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      EXPECT_TRUE(mesh.lower[0][cell] > 0. || std::abs(state.material[0].energy[cell]) < 1e-15);
  }
} // namespace
