// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/debris_selection.h>

#include <whipple/projection/cell_totals.h>

namespace whipple
{
  namespace
  {
    template <int dim>
    Verdict
    judge(const FlatMesh<dim> &mesh, const State<dim> &state, const DebrisCriteria &criteria, Index cell,
          const ConservedTotals<dim> &totals)
    {
      if (totals.mass == 0)
        return Verdict::empty;
      constexpr int axis     = flight_axis<dim>;
      const double  position = mesh.lower[axis][cell] + 0.5 * mesh.size[cell];
      if (criteria.plane && (position - *criteria.plane) * criteria.direction < 0)
        return Verdict::not_debris;
      if (criteria.least_velocity &&
          totals.momentum[axis] * criteria.direction < *criteria.least_velocity * totals.mass)
        return Verdict::not_debris;
      double solid = 0;
      for (const MaterialState &material : state.material)
        solid += material.volume[cell] * (material.has_voids() ? 1. - material.void_fraction[cell] : 1.);
      if (1. - solid / state.volume[cell] > criteria.void_cutoff)
        return Verdict::void_cutoff;
      return Verdict::kept;
    }
  } // namespace

  template <int dim>
  DebrisSelection<dim>
  select_debris(const FlatMesh<dim> &mesh, const State<dim> &state, const DebrisCriteria &criteria)
  {
    const CornerVelocities<dim> velocities = corner_velocities<dim>(mesh, state);
    DebrisSelection<dim>        selection;
    selection.verdict.resize(mesh.n_owned);
    for (Index cell = 0; cell < mesh.n_owned; ++cell)
      {
        const ConservedTotals<dim> totals  = cell_totals<dim>(state, velocities, cell);
        const Verdict              verdict = judge(mesh, state, criteria, cell, totals);
        selection.verdict[cell]            = verdict;
        selection.amount[static_cast<int>(verdict)] += totals;
      }
    return selection;
  }

  template DebrisSelection<2>
  select_debris<2>(const FlatMesh<2> &, const State<2> &, const DebrisCriteria &);
} // namespace whipple
