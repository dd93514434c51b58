// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/pack.h>
#include <whipple/hydro/step_work.h>

/// Traces: material of which a cell holds too little to have a state of its own. Equations and reasons:
/// doc/theory/traces.md.
namespace whipple::trace
{
  /// A material is a trace where its mass is at most this share of what would fill the cell at the least density at
  /// which the scene brings it in.
  inline constexpr double share = 2e-6;

  /// Lanes in which a material has a state of its own.
  /// @param volume of the cells, cm^3
  template <int dim>
  inline Pack::mask_type
  has_state(const MaterialState &material, const MaterialWork<dim> &work, const Pack &volume, Index first)
  {
    return load(material.mass, first) > work.trace_density * volume;
  }

  /// The same for one cell.
  template <int dim>
  inline bool
  has_state(const MaterialState &material, const MaterialWork<dim> &work, double volume, Index cell)
  {
    return material.mass[cell] > work.trace_density * volume;
  }
} // namespace whipple::trace
