// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/index.h>

/// Material interface in a cell: the half-space normal . (x - lower) <= offset of an axis-aligned box holds
/// the material; `normal` points out of the material. Measures are true volumes (r-weighted, 2 pi included,
/// in axisymmetry), so a reconstructed cell holds exactly its volume also at the axis.
namespace whipple::interface_plane
{
  /// True volume of {x in [box_lower, box_upper] : normal . (x - origin) <= offset}.
  template <int dim>
  double
  volume_below(Symmetry symmetry, const Vector<dim> &box_lower, const Vector<dim> &box_upper, const Vector<dim> &origin,
               const Vector<dim> &normal, double offset);

  /// The offset (relative to origin = box_lower) for which volume_below of the whole box is
  /// fraction * volume(box), to round-off.
  template <int dim>
  double
  offset_of_fraction(Symmetry symmetry, const Vector<dim> &box_lower, const Vector<dim> &box_upper,
                     const Vector<dim> &normal, double fraction);
} // namespace whipple::interface_plane
