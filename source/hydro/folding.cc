// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/cell_shape.h>
#include <whipple/hydro/folding.h>

namespace whipple
{
  namespace
  {
    bool
    has_mass(const State<2> &state, Index cell)
    {
      double mass = 0;
      for (const MaterialState &material : state.material)
        mass += material.mass[cell];
      return mass > 0;
    }
  } // namespace

  template <int dim>
  std::vector<Index>
  folding_cells(const FlatMesh<dim> &mesh, const State<dim> &state, double dt)
  {
    std::vector<Index> cells;
    for (Index c = 0; c < mesh.n_owned; ++c)
      if (mesh.intact[c] && CellShape<2>::crosses(cell_shape::corners_after(mesh, state, c, dt)) &&
          cell_shape::shares_nodes(mesh, c) && has_mass(state, c))
        cells.push_back(c);
    return cells;
  }

  template <int dim>
  std::vector<Index>
  folded_cells(const FlatMesh<dim> &mesh, const State<dim> &state)
  {
    std::vector<Index> cells;
    for (Index c = 0; c < mesh.n_owned; ++c)
      if (CellShape<2>::crosses(cell_shape::corners_after(mesh, state, c, 0.)) && has_mass(state, c))
        cells.push_back(c);
    return cells;
  }

  template std::vector<Index>
  folding_cells(const FlatMesh<2> &, const State<2> &, double);
  template std::vector<Index>
  folded_cells(const FlatMesh<2> &, const State<2> &);
} // namespace whipple
