// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include "source_directory.h"

#include <gtest/gtest.h>

std::string
source_directory()
{
  return WHIPPLE_SOURCE_DIR;
}

/// GoogleTest's main with MPI around it, for tests on one rank or several.
int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
