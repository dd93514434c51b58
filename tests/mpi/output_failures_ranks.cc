// SPDX-License-Identifier: LGPL-2.1-or-later
// What the first rank cannot write or go on with is an error on all ranks: nobody waits for it.
#include <whipple/error.h>
#include <whipple/output/run_log.h>
#include <whipple/output/step_table.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
  using namespace whipple;

  /// What all ranks get to know of a failure; the text of this rank where they differ. Collective.
  template <typename Work>
  std::string
  failure_of(const Work &work)
  {
    std::string message;
    try
      {
        work();
      }
    catch (const InputError &error)
      {
        message = error.what();
      }
    int failed = message.empty() ? 0 : 1, all = 0, ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    MPI_Allreduce(&failed, &all, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_TRUE(all == 0 || all == ranks) << all << " of " << ranks << " ranks: " << message;
    return message;
  }

  const std::string nowhere = "no/such/folder";

  TEST(OutputFailuresRanks, ATableThatCannotBeWritten)
  {
    EXPECT_EQ(failure_of([] { StepTable(nowhere + "/table.csv", MPI_COMM_WORLD); }),
              nowhere + "/table.csv: cannot be written");
  }

  TEST(OutputFailuresRanks, ATableThatIsShorterThanItsCheckpointSays)
  {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const std::string path = testing::TempDir() + "whipple_short_table.csv";
    if (rank == 0)
      std::ofstream(path) << "a,b\n";
    MPI_Barrier(MPI_COMM_WORLD);
    EXPECT_EQ(failure_of([&] { StepTable(path, MPI_COMM_WORLD, 5); }),
              path + ": is shorter than the 5 bytes that were written to it");
    EXPECT_EQ(failure_of([&] { StepTable(path, MPI_COMM_WORLD, 4); }), "");
    MPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0)
      std::filesystem::remove(path);
  }

  TEST(OutputFailuresRanks, ALogThatCannotBeWritten)
  {
    std::ostringstream terminal;
    EXPECT_EQ(failure_of([&] { RunLog(nowhere, MPI_COMM_WORLD, terminal, false, 1.); }),
              nowhere + "/log.txt: cannot be written");
  }
} // namespace
