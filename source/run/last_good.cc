// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/run/last_good.h>
#include <whipple/run/state_rows.h>

namespace whipple
{
  template <int dim>
  void
  LastGood<dim>::keep(const RunState<dim> &run)
  {
    if (view_ != run.domain.view)
      {
        view_  = run.domain.view;
        image_ = std::make_shared<const MeshImage>(image_of(run.domain.forest, *view_));
      }
    state_ = run.domain.state;
    books_ = run.books;
  }

  template <int dim>
  void
  LastGood<dim>::keep_books(const RunBooks<dim> &books)
  {
    books_ = books;
  }

  template <int dim>
  bool
  LastGood<dim>::restore(const FieldLayout &layout, RunState<dim> &run)
  {
    run.books = books_;
    if (!view_)
      return false;
    if (view_ == run.domain.view)
      {
        run.domain.state = state_;
        return false;
      }
    const StateRows rows = to_rows(layout, view_->mesh, state_);
    view_                = rebuild(*image_, run.domain.forest);
    run.domain.view      = view_;
    from_rows(layout, redistribute(rows, view_->mesh.n_owned, run.domain.communicator()), state_.time, run.domain);
    state_ = run.domain.state;
    return true;
  }

  template class LastGood<2>;
} // namespace whipple
