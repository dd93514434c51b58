// SPDX-License-Identifier: LGPL-2.1-or-later
// What a full disk does to those who write: one message, no loss in silence.
#include "complaint.h"

#include <whipple/error.h>
#include <whipple/output/disk_room.h>
#include <whipple/output/step_table.h>
#include <whipple/output/summary.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace
{
  using namespace whipple;

  TEST(OutputDiskRoom, AFileThatDoesNotFitIsRefusedBeforeItIsWritten)
  {
    const std::string path = (std::filesystem::temp_directory_path() / "fields.h5").string();
    EXPECT_EQ(complaint_of<std::exception>([&] { require_disk_room(path, 1000, MPI_COMM_SELF); }), "");
    const std::string said =
        complaint_of<std::exception>([&] { require_disk_room(path, std::size_t(1) << 60, MPI_COMM_SELF); });
    EXPECT_TRUE(said.starts_with(path + ": No space left on device: about 1.18e+12 MB are needed")) << said;
    EXPECT_NE(complaint_of<std::exception>([] { require_disk_room("/no/such/folder/fields.h5", 1, MPI_COMM_SELF); }),
              "");
  }

  TEST(OutputDiskRoom, ATableSaysThatTheDiskIsFull)
  {
    if (!std::filesystem::exists("/dev/full"))
      GTEST_SKIP() << "no /dev/full here";
    StepTable                     table("/dev/full", MPI_COMM_SELF);
    const std::vector<TableEntry> row{{"time [us]", 0.5}};
    table.write(row);
    EXPECT_EQ(complaint_of<std::exception>([&] {
                table.keep();
                table.flush();
              }),
              "/dev/full: cannot be written: No space left on device");
  }
} // namespace
