// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/stage/domain.h>

namespace whipple
{
  template <int dim>
  void
  exchange_cells(const FieldLayout &layout, const Halo<dim> &halo, State<dim> &state)
  {
    halo.exchange(layout.cell_arrays(state), {});
  }

  template <int dim>
  void
  exchange_corners(const Halo<dim> &halo, CornerVelocities<dim> &corners)
  {
    std::vector<std::vector<double> *> velocities;
    for (auto &v : corners.velocity)
      velocities.push_back(&v);
    halo.exchange_corners(velocities);
    halo.exchange(std::vector<std::vector<double> *>{&corners.kinetic_remainder}, {});
  }

  template void
  exchange_cells(const FieldLayout &, const Halo<2> &, State<2> &);
  template void
  exchange_corners(const Halo<2> &, CornerVelocities<2> &);
} // namespace whipple
