// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <whipple/state/exact_sum.h>

#include <cmath>
#include <random>
#include <vector>

namespace whipple
{
  namespace
  {
    // Terms of 600 binary orders of magnitude, dealt to the ranks in turn: the bits of one rank.
    TEST(ExactSumRanks, SameBitsHoweverTheTermsAreSpread)
    {
      int rank = 0, size = 1;
      MPI_Comm_rank(MPI_COMM_WORLD, &rank);
      MPI_Comm_size(MPI_COMM_WORLD, &size);
      std::mt19937_64         random(5);
      std::array<ExactSum, 2> all, mine;
      for (int i = 0; i < 9000; ++i)
        {
          const double term = std::ldexp(std::uniform_real_distribution<double>(-1., 1.)(random),
                                         static_cast<int>(random() % 600) - 300);
          all[0].add(term);
          all[1].add(std::abs(term));
          if (i % size == rank)
            {
              mine[0].add(term);
              mine[1].add(std::abs(term));
            }
        }
      ExactSum::reduce(mine, MPI_COMM_WORLD);
      EXPECT_EQ(mine[0].value(), all[0].value());
      EXPECT_EQ(mine[1].value(), all[1].value());
    }
  } // namespace
} // namespace whipple
