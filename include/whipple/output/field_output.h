// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/output/snapshot.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <string>
#include <string_view>
#include <vector>

namespace whipple
{
  /// What field files hold and how.
  struct FieldOutputOptions
  {
    bool hdf5        = true;  ///< DIR/fields.xdmf and DIR/fields/fields-NNNNN.h5
    bool vtu         = false; ///< DIR/fields/fields-NNNNN.vtu
    bool empty_cells = false; ///< also active cells without material
  };

  /// The field files written so far.
  struct FieldSeries
  {
    std::vector<std::string> grids; ///< XDMF grid of each time
    std::vector<double>      shown; ///< us, the times under which readers find them: each larger than the last

    std::string stage;     ///< of the last state written
    double      time = -1; ///< of the last state written, us
  };

  /// Fields of a run for ParaView: DIR/fields.xdmf (of VTU files DIR/fields.pvd) is the time series of the whole chain
  /// of stages, DIR/fields/fields-NNNNN.h5 (.vtu) the data of one time. A hand-over has two states at one time; readers
  /// need distinct ones, so the later is shown a billionth of the time later. Files hold the true time.
  /// Elements are drawn where the nodes are (deformed in a Lagrangian stage); cell fields are one value a cell (XDMF
  /// attributes on cells, single precision), velocity sits on the nodes. Every rank writes its own nodes: those on the
  /// border of two ranks are there twice.
  ///
  /// HDF5 goes through deal.II's HDF5 interface and not through DataOutInterface::write_hdf5_parallel: that one
  /// stores each value once a corner and in double precision (eight times the bytes) and crashes on ranks
  /// without cells in deal.II 9.4.
  template <int dim>
  class FieldOutput
  {
  public:
    /// @param material_names one a material of the states to come, as they shall appear in field names.
    /// @param extra          what else to show; may be empty
    FieldOutput(std::string directory, std::vector<std::string> material_names, FieldOutputOptions options,
                MPI_Comm communicator, ExtraFields<dim> extra = {});

    /// Write owned cells of the state at state.time under the name of its stage, and the series. Collective.
    /// Nothing is written where no rank has a cell to show, or if it is the state written last: same stage and time.
    void
    write(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived, std::string_view stage);

    /// Number of times written so far.
    int
    count() const
    {
      return static_cast<int>(series_.shown.size());
    }

    const FieldSeries &
    series() const
    {
      return series_;
    }

    /// Go on after the files of a series: those written since are overwritten.
    void
    go_on(const FieldSeries &series)
    {
      series_ = series;
    }

  private:
    /// The time under which readers find a state of this time, us: later than that of the state before, by as little as
    /// they can tell apart.
    double
    shown_time(double time) const;
    /// Its folder is there, and the manifest lists it.
    void
    make_room_for(const std::string &name);
    /// DIR/fields.pvd: times and names of all VTU files.
    void
    write_record() const;

    std::string              directory_;
    std::vector<std::string> material_names_;
    FieldOutputOptions       options_;
    MPI_Comm                 communicator_;
    ExtraFields<dim>         extra_;
    FieldSeries              series_;
  };

  /// Write everything a rank holds in its owned cells, in double precision and with cell keys, masses and
  /// volumes: directory/last_good_state/rank-NNNNN.h5 with an .xdmf to look at it, and README.txt (rank 0) that
  /// says why. Not collective: works on whatever ranks still can.
  template <int dim>
  void
  write_last_good_state(const std::string &directory, const FlatMesh<dim> &mesh, const State<dim> &state,
                        const Derived &derived, const std::vector<std::string> &material_names, std::string_view stage,
                        std::string_view reason, MPI_Comm communicator);
} // namespace whipple
