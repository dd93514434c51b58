// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/field_output.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/snapshot_hdf5.h>
#include <whipple/output/snapshot_vtu.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <utility>

namespace whipple
{
  namespace
  {
    int
    rank_in(MPI_Comm communicator)
    {
      int rank = 0;
      MPI_Comm_rank(communicator, &rank);
      return rank;
    }

    /// "fields-" and 7 -> "fields-00007"
    std::string
    numbered(const char *stem, int number)
    {
      std::array<char, 16> digits;
      std::snprintf(digits.data(), digits.size(), "%05d", number);
      return std::string(stem) + digits.data();
    }
  } // namespace

  template <int dim>
  FieldOutput<dim>::FieldOutput(std::string directory, std::vector<std::string> material_names,
                                FieldOutputOptions options, MPI_Comm communicator, ExtraFields<dim> extra)
    : directory_(std::move(directory))
    , material_names_(std::move(material_names))
    , options_(options)
    , communicator_(communicator)
    , extra_(std::move(extra))
  {
    on_first_rank<Error>(communicator_, [&] { std::filesystem::create_directories(directory_ + "/fields"); });
  }

  template <int dim>
  void
  FieldOutput<dim>::write(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                          std::string_view stage)
  {
    const int           rank = rank_in(communicator_);
    const Snapshot<dim> snapshot =
        take_snapshot(mesh, state, derived, material_names_, extra_,
                      {.empty_cells = options_.empty_cells, .everything = false, .rank = rank});
    std::uint64_t n_cells = snapshot.n_cells();
    MPI_Allreduce(MPI_IN_PLACE, &n_cells, 1, MPI_UINT64_T, MPI_SUM, communicator_);
    if (n_cells == 0)
      return;
    const std::string stem = "fields/" + numbered("fields-", series_.count++);
    if (options_.hdf5)
      {
        series_.grids.push_back(snapshot_hdf5::write(snapshot, directory_ + '/' + stem + ".h5", stem + ".h5", stage,
                                                     snapshot_hdf5::Precision::single_precision, communicator_));
        on_first_rank<Error>(communicator_,
                             [&] { snapshot_hdf5::write_series(directory_ + "/fields.xdmf", series_.grids); });
      }
    if (options_.vtu)
      snapshot_vtu::write(snapshot, directory_ + '/' + stem + ".vtu", communicator_);
  }

  template <int dim>
  void
  write_last_good_state(const std::string &directory, const FlatMesh<dim> &mesh, const State<dim> &state,
                        const Derived &derived, const std::vector<std::string> &material_names, std::string_view stage,
                        std::string_view reason, MPI_Comm communicator)
  {
    const std::string folder = directory + "/last_good_state/";
    const int         rank   = rank_in(communicator);
    std::filesystem::create_directories(folder);
    if (rank == 0)
      {
        std::ofstream text(folder + "README.txt");
        text.precision(17);
        text << "The run stopped in stage '" << stage << "': " << reason
             << "\nrank-NNNNN.h5 holds what each rank owned at t = " << state.time
             << " us, the last state known to be good, in double precision;\nopen rank-NNNNN.xdmf to look at it.\n";
      }
    const Snapshot<dim> snapshot = take_snapshot<dim>(mesh, state, derived, material_names, {},
                                                      {.empty_cells = true, .everything = true, .rank = rank});
    const std::string   name     = numbered("rank-", rank);
    if (snapshot.n_cells() == 0)
      return;
    const std::string grid = snapshot_hdf5::write(snapshot, folder + name + ".h5", name + ".h5", stage,
                                                  snapshot_hdf5::Precision::double_precision, MPI_COMM_SELF);
    snapshot_hdf5::write_series(folder + name + ".xdmf", std::array<std::string, 1>{{grid}});
  }

  template class FieldOutput<2>;
  template void
  write_last_good_state<2>(const std::string &, const FlatMesh<2> &, const State<2> &, const Derived &,
                           const std::vector<std::string> &, std::string_view, std::string_view, MPI_Comm);
} // namespace whipple
