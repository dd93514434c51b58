// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/state/fields.h>

namespace whipple
{
  /// Copy what a cell holds to a cell of another state with the same materials and fields: volume, corner weights and
  /// materials; not its nodes.
  template <int dim>
  void
  copy_cell(const State<dim> &source, Index from, State<dim> &target, Index to)
  {
    constexpr int corners = State<dim>::corners;
    for (int k = 0; k < corners; ++k)
      target.corner_weight[to * corners + k] = source.corner_weight[from * corners + k];
    target.volume[to] = source.volume[from];
    for (std::size_t m = 0; m < source.material.size(); ++m)
      {
        const MaterialState &a = source.material[m];
        MaterialState       &b = target.material[m];
        b.volume[to]           = a.volume[from];
        b.mass[to]             = a.mass[from];
        b.density[to]          = a.density[from];
        b.energy[to]           = a.energy[from];
        if (a.has_voids())
          b.void_fraction[to] = a.void_fraction[from];
        for (std::size_t f = 0; f < a.fields.size(); ++f)
          b.fields[f].value[to] = a.fields[f].value[from];
      }
  }
} // namespace whipple
