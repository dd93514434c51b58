// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/lagrange_step.h>
#include <whipple/run/domain.h>
#include <whipple/state/velocity_gather.h>

namespace whipple
{
  template <int dim>
  void
  clear_state(const FieldLayout &layout, Domain<dim> &domain)
  {
    const double time = domain.state.time;
    domain.state      = layout.allocate(domain.view->mesh);
    domain.state.time = time;
    initialise_geometry(domain.view->mesh, domain.state);
  }

  template <int dim>
  Booking<dim>
  unpack_leaves(const FieldLayout &fields, const CellPacketLayout<dim> &layout, const std::vector<CellPacket> &packets,
                const Boundaries<dim> &boundaries, KineticLoss loss, Domain<dim> &domain)
  {
    const FlatMesh<dim>  &mesh = domain.view->mesh;
    CornerVelocities<dim> corners(mesh.n_cells);
    for (Index c = 0; c < mesh.n_owned; ++c)
      unpack(layout, packets[domain.view->leaf_of_cell[c]], domain.state, c, corners);
    exchange_cells(fields, domain.view->halo, domain.state);
    exchange_corners(domain.view->halo, corners);
    return sum_over_ranks(gather_velocities(mesh, boundaries, corners, loss, domain.state), domain.communicator());
  }

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
  clear_state(const FieldLayout &, Domain<2> &);
  template Booking<2>
  unpack_leaves(const FieldLayout &, const CellPacketLayout<2> &, const std::vector<CellPacket> &,
                const Boundaries<2> &, KineticLoss, Domain<2> &);
  template void
  exchange_cells(const FieldLayout &, const Halo<2> &, State<2> &);
  template void
  exchange_corners(const Halo<2> &, CornerVelocities<2> &);
} // namespace whipple
