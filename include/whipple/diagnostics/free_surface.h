// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/measure.h>
#include <whipple/diagnostics/mesh_point.h>

namespace whipple
{
  /// Where an instrument sees a body from outside, along axis 1 on the lower side of axis 0.
  template <int dim>
  struct SurfacePoint
  {
    MeshPoint<dim> point;         ///< whose nodes say how fast it moves
    double         position = 0.; ///< cm along axis 1
  };

  /// The outermost of this rank's cells along that side that the body fills by half or more, and the surface in it. On
  /// a fixed mesh the surface stands where the materials of that cell and the one beyond it reach to; on a moving mesh
  /// it is the element's corner. Smaller pieces before it are not seen (doc/theory/gauges.md).
  template <int dim>
  SurfacePoint<dim>
  find_surface(const MeasureView<dim> &view, std::size_t body, bool rear);
} // namespace whipple
