// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hydro_case.h"

#include <whipple/hydro/deviator.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>
#include <whipple/material/rate_void_law.h>

#include <limits>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;
  constexpr double shear = 0.286, yield = 0.0026;

  std::vector<Material>
  aluminium(bool voids)
  {
    Material material;
    material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.79, 0.533, 1.34, 2.});
    material.strength = std::make_shared<PerfectlyPlastic>(shear, yield);
    if (voids)
      material.void_law = std::make_shared<RateVoidLaw>(1000., std::numeric_limits<double>::infinity());
    return {material};
  }

  FlatMesh<2>
  box(Symmetry symmetry)
  {
    const Lattice<2> grid{symmetry, {{0.5, -0.3}}, 0.05, {{6, 6}}, 0};
    return build(grid, uniform_keys(grid));
  }

  State<2>
  solid(const FlatMesh<2> &mesh, const std::vector<Material> &materials)
  {
    State<2> state = make_state(mesh, materials);
    fill_all(state, 2.79, 0.);
    return state;
  }

  TEST(HydroStrength, StressTurnsWithTheMaterial)
  {
    // 60 degrees in 5 rotations, each given by its spin at mid step
    const double angle = std::acos(-1.) / 3., step = angle / 5.;
    Deviator<2>  s{{0.001, -0.0004, 0.0003}};
    const auto   start = s.component;
    for (int i = 0; i < 5; ++i)
      s = s.turned(2. * std::tan(0.5 * step), 1.);
    const double c = std::cos(angle), n = std::sin(angle);
    EXPECT_NEAR(s.component[0], c * c * start[0] + n * n * start[1] - 2. * c * n * start[2], 1e-18);
    EXPECT_NEAR(s.component[1], n * n * start[0] + c * c * start[1] + 2. * c * n * start[2], 1e-18);
    EXPECT_NEAR(s.component[2], c * n * (start[0] - start[1]) + (c * c - n * n) * start[2], 1e-18);
  }

  TEST(HydroStrength, ElasticShearGivesTheAnalyticStress)
  {
    const FlatMesh<2> mesh      = box(Symmetry::planar);
    const auto        materials = aluminium(false);
    State<2>          state     = solid(mesh, materials);
    set_velocity(mesh, state, [](double, double y) { return Vector<2>{{1e-3 * y, 0.}}; });
    LagrangeStep<2> step(mesh, materials, sides(BoundaryKind::transmitting), {});
    step.update_node_mass(state);
    advance(step, state, 0.01);
    // cells whose nodes no free side has touched
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        bool inner = true;
        for (int k = 0; k < 4; ++k)
          inner = inner && mesh.node_side[mesh.cell_node[cell * 4 + k]] == 0;
        const double expected = shear * 1e-3 * 0.01;
        EXPECT_NEAR(inner ? state.material[0].fields[2].value[cell] : expected, expected, 1e-8 * expected);
      }
  }

  TEST(HydroStrength, RadialReturnEndsOnTheYieldSurface)
  {
    const FlatMesh<2> mesh      = box(Symmetry::axisymmetric);
    const auto        materials = aluminium(false);
    State<2>          state     = solid(mesh, materials);
    set_velocity(mesh, state, [](double r, double z) { return Vector<2>{{-0.5 * r, z}}; });
    LagrangeStep<2> step(mesh, materials, sides(BoundaryKind::transmitting), {});
    step.update_node_mass(state);
    const auto report = advance(step, state, 0.02);
    EXPECT_GT(report.plastic_work, 0.);
    for (Index cell = 0; cell < mesh.n_cells; ++cell)
      {
        const auto &field = state.material[0].fields;
        EXPECT_NEAR(StoredDeviator<2>(state.material[0], state.index).at(cell).equivalent(), yield, 1e-15);
        EXPECT_GT(field[3].value[cell], 0.);
      }
  }

  TEST(HydroStrength, ForceScalesWithShareAndPores)
  {
    const FlatMesh<2> mesh      = box(Symmetry::planar);
    const auto        materials = aluminium(true);
    const auto        impulse   = [&](double share, double phi) {
      State<2> state = make_state(mesh, materials);
      for (Index cell = 0; cell < mesh.n_cells; ++cell)
        {
          fill(state, cell, 2.79 * (1. - phi), 0., 0, share);
          state.material[0].void_fraction[cell]   = phi;
          state.material[0].fields[2].value[cell] = mesh.lower[0][cell] < 0.64 ? 1e-3 : 0.;
        }
      LagrangeStep<2> step(mesh, materials, sides(BoundaryKind::reflecting), {});
      step.update_node_mass(state);
      advance(step, state, 1e-4);
      double largest = 0;
      for (Index node = 0; node < mesh.n_nodes; ++node)
        if (mesh.node_side[node] == 0)
          largest = std::max(largest, std::abs(state.velocity[1][node] * state.node_mass[node]));
      return largest;
    };
    const double full = impulse(1., 0.);
    EXPECT_NEAR(full, 1e-4 * 1e-3 * 0.05, 1e-12 * full);
    EXPECT_NEAR(impulse(0.4, 0.), 0.4 * full, 1e-12 * full);
    EXPECT_NEAR(impulse(1., 0.7), 0.3 * full, 1e-12 * full);
    EXPECT_NEAR(impulse(0.5, 0.7), 0.15 * full, 1e-12 * full);
  }

  TEST(HydroStrength, VoidLawThatOpensNothingChangesNoBit)
  {
    const FlatMesh<2> mesh = box(Symmetry::axisymmetric);
    const auto        with = aluminium(true), without = aluminium(false);
    State<2>          a = solid(mesh, with), b = solid(mesh, without);
    for (State<2> *state : {&a, &b})
      set_velocity(mesh, *state, [](double r, double z) {
        return Vector<2>{{0.1 * std::sin(20. * z), 0.1 * std::cos(15. * r)}};
      });
    LagrangeStep<2> step_a(mesh, with, sides(BoundaryKind::reflecting), {});
    LagrangeStep<2> step_b(mesh, without, sides(BoundaryKind::reflecting), {});
    run(step_a, a, 0.05);
    run(step_b, b, 0.05);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.velocity, b.velocity);
    EXPECT_EQ(a.material[0].energy, b.material[0].energy);
    EXPECT_EQ(evaluate(step_a, a).material[0].pressure, evaluate(step_b, b).material[0].pressure);
    for (const double phi : a.material[0].void_fraction)
      EXPECT_EQ(phi, 0.);
  }
} // namespace
