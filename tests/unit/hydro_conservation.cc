// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../figure.h"
#include "hydro_case.h"

#include <whipple/error.h>
#include <whipple/material/ideal_gas.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>
#include <whipple/material/rate_void_law.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  Material
  gas()
  {
    Material material;
    material.name = "gas";
    material.eos  = std::make_shared<IdealGas>(5. / 3., 1.);
    return material;
  }

  Material
  aluminium(bool voids)
  {
    Material material;
    material.name     = "aluminium";
    material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.79, 0.533, 1.34, 2.});
    material.strength = std::make_shared<PerfectlyPlastic>(0.286, 0.0026);
    if (voids)
      material.void_law = std::make_shared<RateVoidLaw>(1000., 0.012);
    return material;
  }

  Lattice<2>
  lattice(Symmetry symmetry)
  {
    return {symmetry, {{0., -0.3}}, 0.05, {{6, 7}}, 1};
  }

  FlatMesh<2>
  mesh_with_hanging_nodes(Symmetry symmetry, Cohesion cohesion = Cohesion::bonded)
  {
    const Lattice<2> grid = lattice(symmetry);
    return build(
        grid,
        two_level_keys(grid, [](int i, int j) { return (i > 1 && i < 4 && j > 1 && j < 5) || (i == 0 && j == 5); }),
        cohesion);
  }

  /// Nodes moved by up to a tenth of the finest cell, those on the axis along it.
  void
  distort(const FlatMesh<2> &mesh, State<2> &state, std::mt19937 &random)
  {
    std::uniform_real_distribution<double> shift(-0.007, 0.007);
    for (Index node = 0; node < mesh.n_nodes; ++node)
      for (int d = 0; d < 2; ++d)
        {
          const double s = shift(random);
          if (d == 1 || !(mesh.node_side[node] & 1))
            state.position[d][node] += s;
        }
    constrain(mesh, state.position);
    initialise_geometry(mesh, state);
  }

  class HydroConservation : public testing::TestWithParam<Symmetry>
  {
  };

  TEST_P(HydroConservation, UniformPressureAtRestStaysAtRest)
  {
    const std::vector<Material> materials{gas()};
    const FlatMesh<2>           mesh  = mesh_with_hanging_nodes(GetParam());
    State<2>                    state = make_state(mesh, materials);
    std::mt19937                random(1);
    distort(mesh, state, random);
    // a free outer side would accelerate; the nodes inside and on the axis must not
    fill_all(state, 1.3, 0.7);
    Boundaries<2> boundaries = sides(BoundaryKind::transmitting);
    boundaries[0].kind       = BoundaryKind::reflecting;
    LagrangeStep<2> step(mesh, materials, boundaries, {});
    step.update_node_mass(state);
    const double dt = time_step(step, state).dt;
    advance(step, state, dt);
    const double sound = evaluate(step, state).material[0].sound_speed[0];

    // nodes of the free outside, and hanging nodes that follow them
    std::vector<bool> outside(mesh.n_nodes);
    for (Index node = 0; node < mesh.n_nodes; ++node)
      outside[node] = (mesh.node_side[node] & ~1) != 0;
    for (std::size_t h = 0; h < mesh.hanging.size(); ++h)
      outside[mesh.hanging[h]] = outside[mesh.master[h][0]] || outside[mesh.master[h][1]];
    int             inside = 0;
    figure::Largest speed("velocity after a step / sound speed", "round-off");
    for (Index node = 0; node < mesh.n_nodes; ++node)
      if (!outside[node])
        {
          ++inside;
          for (const auto &component : state.velocity)
            speed(component[node] / sound);
          EXPECT_LT(std::abs(state.velocity[0][node]), 3e-14 * sound) << "node " << node;
          EXPECT_LT(std::abs(state.velocity[1][node]), 3e-14 * sound) << "node " << node;
        }
    EXPECT_GT(inside, 40);
  }

  TEST_P(HydroConservation, RandomStatesKeepMassMomentumAndEnergy)
  {
    const std::vector<Material> materials{gas(), aluminium(true)};
    const FlatMesh<2>           mesh = mesh_with_hanging_nodes(GetParam());
    ASSERT_FALSE(mesh.hanging.empty());
    Boundaries<2> boundaries = sides(BoundaryKind::transmitting);
    if (GetParam() == Symmetry::axisymmetric)
      boundaries[0].kind = BoundaryKind::reflecting;
    LagrangeStep<2> step(mesh, materials, boundaries, {});
    figure::Largest mass("mass, relative change in a Lagrange step", "0");
    figure::Largest momentum("momentum, relative change in a Lagrange step", "<= 1e-13");
    figure::Largest energy("total energy, relative change in a Lagrange step", "<= 1e-13");
    for (int seed = 0; seed < 20; ++seed)
      {
        std::mt19937                           random(seed);
        std::uniform_real_distribution<double> unit(0., 1.);
        State<2>                               state = make_state(mesh, materials);
        distort(mesh, state, random);
        for (Index cell = 0; cell < mesh.n_cells; ++cell)
          {
            const double kind = unit(random), share = 0.1 + 0.8 * unit(random);
            const double density = 2.5 + 0.5 * unit(random), phi = unit(random) < 0.5 ? 0. : 0.3 * unit(random);
            state.material[1].void_fraction[cell] = phi;
            if (kind < 0.2)
              fill(state, cell, 1. + unit(random), unit(random));
            else if (kind < 0.5)
              fill(state, cell, density * (1. - phi), 0.02 * unit(random), 1);
            else
              {
                fill(state, cell, density * (1. - phi), 0.02 * unit(random), 1, share);
                if (kind < 0.8)
                  fill(state, cell, 1. + unit(random), 0.1 * unit(random), 0, 1. - share);
              }
            if (state.material[1].mass[cell] > 0)
              for (int i = 0; i < 3; ++i)
                state.material[1].fields[i].value[cell] = 0.002 * (unit(random) - 0.5);
          }
        set_velocity(mesh, state, [&](double, double) { return Vector<2>{{unit(random) - 0.5, unit(random) - 0.5}}; });
        for (Index node = 0; node < mesh.n_nodes; ++node)
          if (GetParam() == Symmetry::axisymmetric && (mesh.node_side[node] & 1))
            state.velocity[0][node] = 0;
        constrain(mesh, state.velocity);
        step.update_node_mass(state);
        for (int i = 0; i < 5; ++i)
          {
            const Totals before = totals(state);
            const auto   report = advance(step, state, 0.3 * time_step(step, state).dt);
            const Totals after  = totals(state);
            EXPECT_EQ(after.mass, before.mass);
            mass(after.mass / before.mass - 1.);
            energy((after.energy - report.boundary_work) / before.energy - 1.);
            EXPECT_NEAR(after.energy - report.boundary_work, before.energy, 1e-13 * before.energy);
            for (int d = GetParam() == Symmetry::axisymmetric; d < 2; ++d)
              {
                momentum((after.momentum[d] - report.boundary_momentum[d] - before.momentum[d]) /
                         before.momentum_size[d]);
                EXPECT_NEAR(after.momentum[d] - report.boundary_momentum[d], before.momentum[d],
                            1e-13 * before.momentum_size[d]);
              }
            EXPECT_GE(report.hourglass_work, 0.);
            for (const MaterialState &m : state.material)
              for (Index cell = 0; cell < mesh.n_cells; ++cell)
                EXPECT_TRUE(m.volume[cell] > 0. || m.mass[cell] == 0.);
          }
      }
  }

  TEST_P(HydroConservation, FragmentsKeepMassMomentumAndEnergy)
  {
    const std::vector<Material> materials{aluminium(true)};
    const FlatMesh<2>           mesh = mesh_with_hanging_nodes(GetParam(), Cohesion::fragments);
    ASSERT_EQ(mesh.n_nodes, 4 * mesh.n_cells);
    LagrangeStep<2>                        step(mesh, materials, sides(BoundaryKind::transmitting), {});
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> unit(-1., 1.);
    State<2>                               state = make_state(mesh, materials);
    fill_all(state, 2.7, 0.01);
    set_velocity(mesh, state, [&](double, double) {
      return Vector<2>{{0.1 * unit(random), 0.5 + 0.1 * unit(random)}};
    });
    step.update_node_mass(state);
    for (int i = 0; i < 10; ++i)
      {
        const Totals before = totals(state);
        const auto   report = advance(step, state, time_step(step, state).dt);
        const Totals after  = totals(state);
        EXPECT_EQ(after.mass, before.mass);
        EXPECT_NEAR(after.energy - report.boundary_work, before.energy, 1e-13 * before.energy);
        EXPECT_NEAR(after.momentum[1] - report.boundary_momentum[1], before.momentum[1],
                    1e-13 * before.momentum_size[1]);
      }
  }

  INSTANTIATE_TEST_SUITE_P(Symmetry, HydroConservation, testing::Values(Symmetry::planar, Symmetry::axisymmetric),
                           [](const auto &info) {
                             return std::string(info.param == Symmetry::planar ? "planar" : "axisymmetric");
                           });

  TEST(HydroFailure, InvertedCellThrowsAndLeavesTheStateAlone)
  {
    const std::vector<Material> materials{aluminium(true)};
    const FlatMesh<2>           mesh  = mesh_with_hanging_nodes(Symmetry::planar);
    State<2>                    state = make_state(mesh, materials);
    fill_all(state, 2.7, 0.01);
    set_velocity(mesh, state, [](double x, double y) { return Vector<2>{{-x, std::sin(9. * x) * y}}; });
    LagrangeStep<2> step(mesh, materials, sides(BoundaryKind::transmitting), {});
    step.update_node_mass(state);
    const State<2> before = state;
    try
      {
        advance(step, state, 5.);
        FAIL() << "an inverted cell went unnoticed";
      }
    catch (const StateError &error)
      {
        EXPECT_NE(std::string(error.what()).find("inside out"), std::string::npos) << error.what();
      }
    EXPECT_EQ(state.position, before.position);
    EXPECT_EQ(state.velocity, before.velocity);
    EXPECT_EQ(state.volume, before.volume);
    EXPECT_EQ(state.material[0].energy, before.material[0].energy);
    State<2> again = before;
    advance(step, state, 1e-3);
    LagrangeStep<2> fresh(mesh, materials, sides(BoundaryKind::transmitting), {});
    advance(fresh, again, 1e-3);
    EXPECT_EQ(state.material[0].energy, again.material[0].energy);
    EXPECT_EQ(state.position, again.position);
  }
} // namespace
