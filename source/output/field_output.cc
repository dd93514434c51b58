// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/output/field_output.h>
#include <whipple/output/first_rank.h>
#include <whipple/output/manifest.h>
#include <whipple/output/snapshot_hdf5.h>
#include <whipple/output/snapshot_vtu.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
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
  }

  template <int dim>
  void
  FieldOutput<dim>::write(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                          std::string_view stage)
  {
    if (count() > 0 && series_.stage == stage && series_.time == state.time)
      return;
    const int           rank = rank_in(communicator_);
    const Snapshot<dim> snapshot =
        take_snapshot(mesh, state, derived, material_names_, extra_,
                      {.empty_cells = options_.empty_cells, .everything = false, .rank = rank});
    std::uint64_t n_cells = snapshot.n_cells();
    MPI_Allreduce(MPI_IN_PLACE, &n_cells, 1, MPI_UINT64_T, MPI_SUM, communicator_);
    if (n_cells == 0)
      return;
    const std::string stem = "fields/" + numbered("fields-", count());
    series_.stage          = stage;
    series_.time           = state.time;
    series_.shown.push_back(shown_time(state.time));
    if (options_.hdf5)
      {
        make_room_for(stem + ".h5");
        series_.grids.push_back(snapshot_hdf5::write(
            snapshot, directory_ + '/' + stem + ".h5",
            {.path = stem + ".h5", .stage = std::string(stage), .shown_time = series_.shown.back()},
            snapshot_hdf5::Precision::single_precision, communicator_));
        on_first_rank<Error>(communicator_,
                             [&] { snapshot_hdf5::write_series(directory_ + "/fields.xdmf", series_.grids); });
      }
    if (options_.vtu)
      {
        make_room_for(stem + ".vtu");
        snapshot_vtu::write(snapshot, directory_ + '/' + stem + ".vtu", communicator_);
        on_first_rank<Error>(communicator_, [&] { write_record(); });
      }
  }

  template <int dim>
  double
  FieldOutput<dim>::shown_time(double time) const
  {
    // of the time: ParaView's readers tell 1e-15 apart, not 2e-16; people read fewer digits
    constexpr double apart = 1e-9;
    return series_.shown.empty() ? time : std::max(time, series_.shown.back() * (1. + apart));
  }

  template <int dim>
  void
  FieldOutput<dim>::make_room_for(const std::string &name)
  {
    on_first_rank<Error>(communicator_, [&] {
      std::filesystem::create_directories((std::filesystem::path(directory_) / name).parent_path());
      manifest::note(directory_, name);
    });
  }

  template <int dim>
  void
  FieldOutput<dim>::write_record() const
  {
    const std::string path = directory_ + "/fields.pvd";
    std::ofstream     file(path);
    file.precision(std::numeric_limits<double>::max_digits10); // deal.II's writer has 12 digits, and the date
    file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
            "<Collection>\n";
    for (std::size_t i = 0; i < series_.shown.size(); ++i)
      file << "<DataSet timestep=\"" << series_.shown[i] << "\" part=\"0\" file=\"fields/"
           << numbered("fields-", static_cast<int>(i)) << ".vtu\"/>\n";
    file << "</Collection>\n</VTKFile>\n";
    if (!(file << std::flush))
      throw Error(path + ": cannot be written");
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
    const std::string grid = snapshot_hdf5::write(
        snapshot, folder + name + ".h5", {.path = name + ".h5", .stage = std::string(stage), .shown_time = state.time},
        snapshot_hdf5::Precision::double_precision, MPI_COMM_SELF);
    snapshot_hdf5::write_series(folder + name + ".xdmf", std::array<std::string, 1>{{grid}});
  }

  template class FieldOutput<2>;
  template void
  write_last_good_state<2>(const std::string &, const FlatMesh<2> &, const State<2> &, const Derived &,
                           const std::vector<std::string> &, std::string_view, std::string_view, MPI_Comm);
} // namespace whipple
