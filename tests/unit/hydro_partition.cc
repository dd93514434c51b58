// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hydro_case.h"

#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>
#include <whipple/material/rate_void_law.h>

#include <algorithm>
#include <limits>
#include <map>

namespace
{
  using namespace whipple;
  using namespace whipple::hydro_case;

  std::vector<Material>
  aluminium()
  {
    Material material;
    material.eos      = std::make_shared<MieGrueneisen>(MieGrueneisen::Constants{2.79, 0.533, 1.34, 2.});
    material.strength = std::make_shared<PerfectlyPlastic>(0.286, 0.0026);
    material.void_law = std::make_shared<RateVoidLaw>(1000., 0.005);
    return {material};
  }

  std::vector<CellKey>
  keys_of(const Lattice<2> &grid)
  {
    return two_level_keys(grid, [](int i, int j) { return (i + j) % 5 == 2; });
  }

  State<2>
  moving(const FlatMesh<2> &mesh, const std::vector<Material> &materials)
  {
    State<2> state = make_state(mesh, materials);
    fill_all(state, 2.79, 0.);
    set_velocity(mesh, state, [](double r, double z) {
      return Vector<2>{{0.1 * std::sin(9. * z) * r, 0.3 * std::cos(15. * r)}};
    });
    return state;
  }

  TEST(HydroPartition, OrderOfCellsChangesNoBit)
  {
    const Lattice<2>                         grid{Symmetry::axisymmetric, {{0., -0.3}}, 0.025, {{7, 5}}, 1};
    const auto                               materials = aluminium();
    std::vector<CellKey>                     keys      = keys_of(grid);
    std::map<CellKey, std::array<double, 4>> first;
    for (int seed = 0; seed < 4; ++seed)
      {
        const FlatMesh<2> mesh  = build(grid, keys);
        State<2>          state = moving(mesh, materials);
        LagrangeStep<2>   step(mesh, materials, sides(BoundaryKind::reflecting), {});
        run(step, state, 0.1);
        for (Index cell = 0; cell < mesh.n_cells; ++cell)
          {
            const MaterialState        &m = state.material[0];
            const std::array<double, 4> value{m.energy[cell], m.density[cell], m.fields[2].value[cell],
                                              m.void_fraction[cell]};
            if (seed == 0)
              first[mesh.key[cell]] = value;
            else
              EXPECT_EQ(first[mesh.key[cell]], value) << "key " << mesh.key[cell];
          }
        std::shuffle(keys.begin(), keys.end(), std::mt19937(seed));
      }
  }

  TEST(HydroPartition, GarbageInTheHaloIsCarriedNotThrown)
  {
    const Lattice<2>           grid{Symmetry::planar, {{0., 0.}}, 0.025, {{6, 4}}, 1};
    const auto                 materials = aluminium();
    const std::vector<CellKey> keys      = uniform_keys(grid);
    const Index                n_owned   = 48; // four rows of twelve; four more are halo
    std::vector<std::uint8_t>  layer(keys.size(), 0);
    for (std::size_t cell = n_owned; cell < keys.size(); ++cell)
      layer[cell] = static_cast<std::uint8_t>(cell / 12 - 3);
    const FlatMesh<2> mesh  = build_flat_mesh<2>(grid, keys, n_owned, layer, 4, Cohesion::bonded);
    State<2>          state = moving(mesh, materials);
    const Index       last  = mesh.cell_node[4 * (mesh.n_cells - 1) + 3];
    state.position[0][last] = std::numeric_limits<double>::quiet_NaN();
    LagrangeStep<2> step(mesh, materials, sides(BoundaryKind::reflecting), {});
    step.update_node_mass(state);
    EXPECT_NO_THROW(advance(step, state, 0.5 * time_step(step, state).dt));
    for (Index cell = 0; cell < n_owned; ++cell)
      EXPECT_GT(state.volume[cell], 0.);
  }
} // namespace
