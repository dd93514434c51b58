// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/cell_corners.h>
#include <whipple/projection/intact_cells.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    template <int dim>
    double
    damage_of_heaviest(const State<dim> &state, Index cell)
    {
      double heaviest = 0, damage = 0;
      for (const MaterialState &material : state.material)
        if (material.mass[cell] > heaviest)
          {
            heaviest = material.mass[cell];
            damage   = material.fields[state.index.damage].value[cell];
          }
      return damage;
    }

    template <int dim>
    double
    void_share(const State<dim> &state, Index cell)
    {
      double solid = 0;
      for (const MaterialState &material : state.material)
        solid += material.volume[cell] * (material.has_voids() ? 1. - material.void_fraction[cell] : 1.);
      return 1. - solid / state.volume[cell];
    }
  } // namespace

  template <int dim>
  std::vector<std::uint8_t>
  intact_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const BreakCriteria &criteria)
  {
    const bool                has_damage = state.index.damage >= 0;
    std::vector<std::uint8_t> intact(mesh.n_owned);
    for (Index cell = 0; cell < mesh.n_owned; ++cell)
      intact[cell] = (has_damage ? damage_of_heaviest(state, cell) < criteria.damage
                                 : void_share(state, cell) <= criteria.void_fraction) &&
                     CellShape<dim>::convexity(cell_corners(mesh, state.position, cell)) >= criteria.shape;
    return intact;
  }

  template std::vector<std::uint8_t>
  intact_cells<2>(const FlatMesh<2> &, const State<2> &, const BreakCriteria &);
} // namespace whipple
