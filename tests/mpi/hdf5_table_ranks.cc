// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/output/first_rank.h>
#include <whipple/output/hdf5_table.h>

#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>

namespace
{
  using namespace whipple;
  namespace HDF5 = dealii::HDF5;

  /// Counts what HDF5 complains of: without deal.II's assertions nobody else hears it.
  class Complaints
  {
  public:
    Complaints()
    {
      H5Eget_auto2(H5E_DEFAULT, &before_, &data_);
      H5Eset_auto2(H5E_DEFAULT, count, this);
    }

    ~Complaints()
    {
      H5Eset_auto2(H5E_DEFAULT, before_, data_);
    }

    int number = 0;

  private:
    static herr_t
    count(hid_t, void *self)
    {
      ++static_cast<Complaints *>(self)->number;
      return 0;
    }

    H5E_auto2_t before_ = nullptr;
    void       *data_   = nullptr;
  };

  TEST(Hdf5TableRanks, TablesWithoutRowsOnSomeOrAllRanksAreWritten)
  {
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "hdf5_table_ranks.h5";
    const Complaints            complaints;
    const std::vector<double>   nothing, row{1., 2., 3.};
    const bool                  first = is_first_rank(MPI_COMM_WORLD);
    {
      HDF5::File out(file.string(), HDF5::File::FileAccessMode::create, MPI_COMM_WORLD);
      hdf5_table::write(out, "none", nothing, hdf5_table::rows_of(0, MPI_COMM_WORLD), 3);
      hdf5_table::write(out, "one", first ? row : nothing, hdf5_table::rows_of(first ? 1 : 0, MPI_COMM_WORLD), 3);
    }
    {
      HDF5::File in(file.string(), HDF5::File::FileAccessMode::open, MPI_COMM_WORLD);
      EXPECT_EQ(in.open_dataset("none").get_dimensions(), (std::vector<hsize_t>{0, 3}));
      EXPECT_EQ(in.open_dataset("one").get_dimensions(), (std::vector<hsize_t>{1, 3}));
      EXPECT_EQ(in.open_dataset("one").read<std::vector<double>>(), row);
    }
    EXPECT_EQ(complaints.number, 0);
    MPI_Barrier(MPI_COMM_WORLD);
    if (first)
      std::filesystem::remove(file);
  }
} // namespace
