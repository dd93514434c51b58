// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/cell_kernels.h>

namespace whipple::cell_kernels
{
  template <int dim>
  double
  viscous_work(const FlatMesh<dim> &mesh, double dt, const StepWork<dim> &work)
  {
    Pack sum(0.);
    for (Index first = 0, pack = 0; first < mesh.n_owned; first += pack_size, ++pack)
      {
        const CornerVectors<dim, Pack>  v     = gather_corners(mesh, work.mean_velocity, first);
        const CornerVectors<dim, Pack> &force = work.viscous_force[pack];
        Pack                            power(0.);
        for (int k = 0; k < FlatMesh<dim>::corners; ++k)
          power += dot_at_corner(k, force, v);
        sum += select(lanes_below(first, mesh.n_owned), power, Pack(0.));
      }
    return -dt * reduce(sum);
  }

  template double
  viscous_work(const FlatMesh<2> &, double, const StepWork<2> &);
} // namespace whipple::cell_kernels
