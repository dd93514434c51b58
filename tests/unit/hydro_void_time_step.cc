// SPDX-License-Identifier: LGPL-2.1-or-later
#include "../figure.h"
#include "hydro_case.h"

#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/rate_void_law.h>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  TEST(HydroVoidTimeStep, DoesNotDependOnAlphaAndNoAlphaIsUnstable)
  {
    // porous aluminium that is torn apart and pressed together; the 1993 code had its limit near alpha = 1e3
    const Lattice<2>  grid{Symmetry::axisymmetric, {{0., 0.}}, 0.02, {{8, 8}}, 0};
    const FlatMesh<2> mesh  = build(grid, uniform_keys(grid));
    const double      wave  = std::acos(-1.) / 0.08; // at rest at the walls
    double            first = 0;
    figure::Largest   difference("relative difference of dt, alpha 1e-2 .. infinity", "0");
    for (const double alpha : {1e-2, 1., 1e3, 1e6, 1e9, static_cast<double>(INFINITY)})
      {
        Material material;
        material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.785, 0.5328, 1.338, 2.});
        material.void_law = std::make_shared<RateVoidLaw>(alpha, 0.);
        const std::vector<Material> materials{material};
        State<2>                    state = make_state(mesh, materials);
        state.material[0].void_fraction.assign(mesh.n_cells, 0.2);
        fill_all(state, 0.8 * 2.785, 0.01);
        set_velocity(mesh, state, [wave](double r, double z) {
          return Vector<2>{{0.1 * std::sin(wave * r), 0.1 * std::sin(wave * z)}};
        });
        LagrangeStep<2> step(mesh, materials, sides(BoundaryKind::reflecting), {});
        step.update_node_mass(state);
        const double dt = time_step(step, state).dt;
        first           = first > 0 ? first : dt;
        difference(dt / first - 1.);
        EXPECT_EQ(dt, first) << "alpha " << alpha;

        const double before = totals(state).energy;
        run(step, state, 0.2);
        EXPECT_NEAR(totals(state).energy, before, 1e-12 * before);
        for (const double phi : state.material[0].void_fraction)
          EXPECT_TRUE(phi >= 0. && phi < 1.);
      }
  }
} // namespace
