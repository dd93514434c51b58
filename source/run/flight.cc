// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/free_flight.h>
#include <whipple/ledger/totals.h>
#include <whipple/run/flight.h>
#include <whipple/state/copy_cell.h>

namespace whipple
{
  namespace
  {
    /// Copy a cell with nodes of its own, nodes and all.
    template <int dim>
    void
    copy_element(const FlatMesh<dim> &from_mesh, const State<dim> &from, Index source, const FlatMesh<dim> &to_mesh,
                 State<dim> &to, Index target)
    {
      constexpr int corners = FlatMesh<dim>::corners;
      copy_cell(from, source, to, target);
      for (int k = 0; k < corners; ++k)
        {
          const Index a = from_mesh.cell_node[source * corners + k], b = to_mesh.cell_node[target * corners + k];
          to.node_mass[b] = from.node_mass[a];
          for (int d = 0; d < dim; ++d)
            {
              to.position[d][b] = from.position[d][a];
              to.velocity[d][b] = from.velocity[d][a];
            }
        }
    }
  } // namespace

  template <int dim>
  Flight<dim>::Flight(const FieldLayout &layout, const std::vector<std::uint8_t> &flies, Domain<dim> &domain)
    : view_(domain.view)
    , state_(std::move(domain.state))
  {
    std::vector<std::uint8_t> active(domain.forest.leaves().size(), 0);
    for (Index c = 0; c < view_->mesh.n_owned; ++c)
      if (!flies[c])
        {
          of_stepped_.push_back(c);
          active[view_->leaf_of_cell[c]] = 1;
        }
    totals_ = cell_sum(
        view_->mesh, state_, [&](Index c) { return flies[c] != 0; }, domain.communicator());
    domain.state.time = state_.time;
    domain.view       = domain.forest.flatten(active, 0, Cohesion::fragments);
    clear_state(layout, domain);
    for (std::size_t i = 0; i < of_stepped_.size(); ++i)
      copy_element(view_->mesh, state_, of_stepped_[i], domain.view->mesh, domain.state, static_cast<Index>(i));
  }

  template <int dim>
  void
  Flight<dim>::land(Domain<dim> &domain)
  {
    fly(view_->mesh, domain.state.time - state_.time, state_);
    for (std::size_t i = 0; i < of_stepped_.size(); ++i)
      copy_element(domain.view->mesh, domain.state, static_cast<Index>(i), view_->mesh, state_, of_stepped_[i]);
    state_.time  = domain.state.time;
    domain.state = std::move(state_);
    domain.view  = view_;
  }

  template class Flight<2>;
} // namespace whipple
