// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hydro_case.h"

#include <whipple/error.h>
#include <whipple/material/linear_hardening.h>
#include <whipple/material/mie_grueneisen.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  TEST(HydroRetry, AStepAfterOneThatThrewIsThatOfAFreshObject)
  {
    Material material;
    material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.79, 0.533, 1.34, 2.});
    material.strength = std::make_shared<LinearHardening>(LinearHardening::Constants{0.286, 0.0026, 1.});
    const std::vector<Material> materials{material};
    const Lattice<2>            grid{Symmetry::axisymmetric, {{0., 0.}}, 0.05, {{6, 6}}, 0};
    const FlatMesh<2>           mesh  = build(grid, uniform_keys(grid));
    State<2>                    state = make_state(mesh, materials);
    fill_all(state, 2.79, 0.);
    set_velocity(mesh, state, [](double r, double z) {
      return Vector<2>{{0.1 * std::sin(20. * z), 0.1 * std::cos(15. * r)}};
    });
    const auto      walls = sides(BoundaryKind::reflecting);
    LagrangeStep<2> step(mesh, materials, walls, {});
    step.update_node_mass(state);
    advance(step, state, 0.01);
    const State<2> good = state;
    advance(step, state, 0.01); // hardens: other yield stresses from here on
    EXPECT_THROW(advance(step, state, 50.), StateError);

    // back by more than one step, as a run does; no need to say so to the object
    State<2> retried = good, fresh = good;
    advance(step, retried, 0.005);
    LagrangeStep<2> other(mesh, materials, walls, {});
    advance(other, fresh, 0.005);
    EXPECT_EQ(retried.velocity, fresh.velocity);
    EXPECT_EQ(retried.material[0].energy, fresh.material[0].energy);
    for (int f = 0; f < 4; ++f)
      EXPECT_EQ(retried.material[0].fields[f].value, fresh.material[0].fields[f].value) << f;
    EXPECT_NE(fresh.material[0].fields[3].value, good.material[0].fields[3].value); // it did flow
  }
} // namespace
