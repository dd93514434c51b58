// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/state/fields.h>

namespace whipple::projection
{
  /// Volumes by which an overfull cell was made to fit, cm^3.
  struct Squeeze
  {
    double pores = 0; ///< void pressed out of the materials at constant gamma
    double solid = 0; ///< volume that then still did not fit: the materials are compressed by it
  };

  /// Make the materials of a cell fit into it: they first lose voids, all the same fraction of theirs, then volume,
  /// all the same fraction. Mass, e and fields stay. A cell that is not overfull is left alone.
  template <int dim>
  Squeeze
  squeeze_overfull(State<dim> &state, Index cell)
  {
    double filled = 0, pores = 0;
    for (const MaterialState &material : state.material)
      {
        filled += material.volume[cell];
        if (material.has_voids())
          pores += material.void_fraction[cell] * material.volume[cell];
      }
    const double excess = filled - state.volume[cell];
    if (!(excess > 0))
      return {};

    Squeeze      squeeze{pores < excess ? pores : excess, pores < excess ? excess - pores : 0.};
    const double pore_share  = pores > 0 ? squeeze.pores / pores : 0.;
    const double compression = squeeze.solid > 0 ? state.volume[cell] / (filled - squeeze.pores) : 1.;
    for (MaterialState &material : state.material)
      {
        const double volume = material.volume[cell];
        if (volume == 0)
          continue;
        double kept = 1; // of the volume
        if (material.has_voids())
          {
            const double phi             = material.void_fraction[cell];
            kept                         = 1. - pore_share * phi;
            material.void_fraction[cell] = (1. - pore_share) * phi / kept;
          }
        material.volume[cell] = volume * kept * compression;
        material.density[cell] /= kept * compression;
      }
    return squeeze;
  }
} // namespace whipple::projection
