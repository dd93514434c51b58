// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/collective.h>
#include <whipple/run/bond_breaking.h>
#include <whipple/state/velocity_gather.h>

namespace whipple
{
  namespace
  {
    /// The view of the same cells in the same order with other bonds.
    /// @param intact of the owned cells
    template <int dim>
    std::unique_ptr<FlatPartition<dim>>
    rebonded(const Domain<dim> &domain, const std::vector<std::uint8_t> &intact)
    {
      const FlatPartition<dim> &view = *domain.view;
      std::vector<std::uint8_t> active(domain.forest.leaves().size(), 0), holds(active.size(), 0);
      for (Index c = 0; c < view.mesh.n_owned; ++c)
        {
          active[view.leaf_of_cell[c]] = 1;
          holds[view.leaf_of_cell[c]]  = intact[c];
        }
      return domain.forest.flatten(active, view.mesh.halo_width, Bonds(std::move(holds)));
    }

    /// Keep only these cells bonded.
    template <int dim>
    long
    keep_intact(std::vector<std::uint8_t> intact, const Boundaries<dim> &boundaries, KineticLoss loss,
                Domain<dim> &domain, Bookings<dim> &bookings)
    {
      const FlatMesh<dim> &before = domain.view->mesh;
      long                 broken = 0;
      for (Index c = 0; c < before.n_owned; ++c)
        {
          broken += before.intact[c] && !intact[c];
          intact[c] = intact[c] && before.intact[c];
        }
      broken = static_cast<long>(sum_over_ranks(static_cast<double>(broken), domain.communicator()));
      if (broken == 0)
        return 0;

      auto                  view    = rebonded(domain, intact);
      State<dim>           &state   = domain.state;
      CornerVelocities<dim> corners = corner_velocities(before, state);
      exchange_corners(domain.view->halo, corners); // the outermost halo cells cannot see all masters
      for (int d = 0; d < dim; ++d)
        {
          std::vector<double> position(view->mesh.n_nodes);
          for (std::size_t i = 0; i < before.cell_node.size(); ++i)
            position[view->mesh.cell_node[i]] = state.position[d][before.cell_node[i]];
          state.position[d] = std::move(position);
          state.velocity[d].assign(view->mesh.n_nodes, 0.);
        }
      state.node_mass.assign(view->mesh.n_nodes, 0.);
      bookings.enter("broken bonds", sum_over_ranks(gather_velocities(view->mesh, boundaries, corners, loss, state),
                                                    domain.communicator()));
      domain.view = std::move(view);
      return broken;
    }
  } // namespace

  template <int dim>
  long
  free_cells(std::span<const Index> freed, const Boundaries<dim> &boundaries, KineticLoss loss, Domain<dim> &domain,
             Bookings<dim> &bookings)
  {
    std::vector<std::uint8_t> intact(domain.view->mesh.n_owned, 1);
    for (const Index c : freed)
      intact[c] = 0;
    return keep_intact(std::move(intact), boundaries, loss, domain, bookings);
  }

  template <int dim>
  long
  break_bonds(const BreakCriteria &criteria, const Boundaries<dim> &boundaries, KineticLoss loss, Domain<dim> &domain,
              Bookings<dim> &bookings)
  {
    return keep_intact(intact_cells(domain.view->mesh, domain.state, criteria), boundaries, loss, domain, bookings);
  }

  template long
  free_cells(std::span<const Index>, const Boundaries<2> &, KineticLoss, Domain<2> &, Bookings<2> &);
  template long
  break_bonds(const BreakCriteria &, const Boundaries<2> &, KineticLoss, Domain<2> &, Bookings<2> &);
} // namespace whipple
