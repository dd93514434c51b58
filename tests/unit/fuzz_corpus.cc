// SPDX-License-Identifier: LGPL-2.1-or-later
// The corpus of the fuzzing targets: what they start from and what once broke the reader (doc/fuzzing.md).
#include "../fuzz/targets.h"
#include "source_directory.h"

#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
  using namespace whipple;

  TEST(FuzzCorpus, EveryFileIsReadOrRefusedInOneLineWithinASecond)
  {
    for (const fuzz::Target &target : fuzz::targets)
      {
        int files = 0;
        for (const auto &entry :
             std::filesystem::directory_iterator(source_directory() + "/tests/fuzz/corpus/" + target.name))
          {
            std::ostringstream bytes;
            bytes << std::ifstream(entry.path(), std::ios::binary).rdbuf();
            const auto start = std::clock();
            try
              {
                target.run(bytes.str());
              }
            catch (const std::exception &error)
              {
                ADD_FAILURE() << entry.path().string() << ": " << error.what();
              }
            // of this process: what others do on the machine does not count
            EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 1.) << entry.path().string();
            ++files;
          }
        EXPECT_GE(files, 2) << target.name;
      }
  }
} // namespace
