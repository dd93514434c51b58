// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/run/domain.h>

#include <string>
#include <vector>

namespace whipple
{
  /// A state as a table: a row an owned cell, in the order of the cells, a column a carried number. The rows of all
  /// ranks one after the other are the same for every number of ranks, so that a state can move to another partition of
  /// the same mesh. What can be worked out again (pressure, sound speed) is left out.
  struct StateRows
  {
    std::size_t         columns = 0;
    std::vector<double> value; ///< [rows * columns], row by row

    std::size_t
    size() const
    {
      return columns > 0 ? value.size() / columns : 0;
    }
  };

  /// Names of the columns, in order: "aluminium mass", "position 0 of corner 3" ...
  template <int dim>
  std::vector<std::string>
  row_columns(const FieldLayout &layout);

  template <int dim>
  StateRows
  to_rows(const FieldLayout &layout, const FlatMesh<dim> &mesh, const State<dim> &state);

  /// Fill domain.state, on domain.view, halo included. Collective.
  /// @param rows one for each owned cell of the view
  /// @throws StateError if there are more or fewer.
  template <int dim>
  void
  from_rows(const FieldLayout &layout, const StateRows &rows, double time, Domain<dim> &domain);

  /// Move rows between two partitions of the same cells: each rank gives those it has and gets those of its present
  /// cells, the order of all rows unchanged. Collective.
  /// @param wanted number of rows this rank is to have; the sum over the ranks is that of the rows
  StateRows
  redistribute(const StateRows &rows, std::size_t wanted, MPI_Comm communicator);
} // namespace whipple
