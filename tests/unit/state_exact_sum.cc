// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <whipple/state/exact_sum.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace whipple
{
  namespace
  {
    double
    sum_of(const std::vector<double> &terms)
    {
      ExactSum sum;
      for (const double term : terms)
        sum.add(term);
      return sum.value();
    }

    double
    reversed_sum_of(std::vector<double> terms)
    {
      std::reverse(terms.begin(), terms.end());
      return sum_of(terms);
    }

    TEST(ExactSum, ASumOfSumsIsTheSumOfAllTerms)
    {
      ExactSum one, other;
      for (int i = 0; i < 3000; ++i)
        {
          one.add(0x1p-60);
          other.add(i % 2 ? -0x1p70 : 1e-7);
        }
      ExactSum all = one;
      all.add(other);
      std::vector<double> terms(3000, 0x1p-60);
      for (int i = 0; i < 3000; ++i)
        terms.push_back(i % 2 ? -0x1p70 : 1e-7);
      EXPECT_EQ(all.value(), sum_of(terms));
      one.add(std::numeric_limits<double>::quiet_NaN());
      all.add(one);
      EXPECT_TRUE(std::isnan(all.value()));
    }

    constexpr double largest = std::numeric_limits<double>::max(), smallest = 5e-324;

    // Each sum is known from the terms alone: they are powers of two and few.
    TEST(ExactSum, RoundsOnceWhateverTheSizes)
    {
      EXPECT_EQ(sum_of({}), 0.);
      EXPECT_EQ(sum_of({-0.}), 0.);
      EXPECT_EQ(sum_of({1e300, 1., -1e300}), 1.);
      EXPECT_EQ(sum_of({0x1p100, smallest, -0x1p100}), smallest);
      EXPECT_EQ(sum_of({1., 0x1p-53}), 1.) << "a tie goes to the even neighbour";
      EXPECT_EQ(sum_of({1. + 0x1p-52, 0x1p-53}), 1. + 0x1p-51);
      EXPECT_EQ(sum_of({1., 0x1p-53, smallest}), 1. + 0x1p-52) << "just above the tie";
      EXPECT_EQ(sum_of({1., 0x1p-53, -smallest}), 1.) << "just below the tie";
      EXPECT_EQ(sum_of({-1., -0x1p-53, -smallest}), -1. - 0x1p-52);
      EXPECT_EQ(sum_of({smallest, smallest, smallest}), 3. * smallest);
      EXPECT_EQ(sum_of({0x1p-1022, -smallest}), 0x1p-1022 - smallest) << "subnormal";
      EXPECT_EQ(sum_of({-largest, largest, -largest}), -largest);
      EXPECT_EQ(sum_of({largest, largest, -largest}), largest) << "on the way only";
      EXPECT_EQ(sum_of({largest, largest}), std::numeric_limits<double>::infinity());
      EXPECT_EQ(sum_of({-largest, -largest}), -std::numeric_limits<double>::infinity());
      EXPECT_EQ(sum_of({largest, 0x1p969}), largest);
      EXPECT_EQ(sum_of({largest, 0x1p970}), std::numeric_limits<double>::infinity()) << "half a unit beyond";
    }

    // A tank of steel in gram, an element of a micrometre: nothing wraps, nothing gets lost.
    TEST(ExactSum, HasNoScaleOfItsOwn)
    {
      std::mt19937_64     random(7);
      std::vector<double> terms;
      for (int i = 0; i < 3000; ++i)
        terms.push_back(std::uniform_real_distribution<double>(-1., 1.)(random));
      const double one = sum_of(terms);
      for (const int power : {-900, -120, -60, 40, 200, 900})
        {
          std::vector<double> scaled = terms;
          for (double &term : scaled)
            term = std::ldexp(term, power);
          EXPECT_EQ(sum_of(scaled), std::ldexp(one, power)) << power;
        }
      std::vector<double> doubled = terms;
      doubled.insert(doubled.end(), terms.begin(), terms.end());
      EXPECT_EQ(sum_of(doubled), 2. * one);
    }

    // Against quadruple-length arithmetic of another kind: terms whose sum fits into 64-bit integers.
    TEST(ExactSum, AgreesWithIntegersInAnyOrder)
    {
      std::mt19937_64     random(11);
      std::vector<double> terms;
      std::int64_t        exact = 0;
      for (int i = 0; i < 20000; ++i)
        {
          const std::int64_t term = static_cast<std::int64_t>(random() >> 18) - (std::int64_t{1} << 45);
          exact += term;
          terms.push_back(std::ldexp(static_cast<double>(term), -30));
        }
      const double expected = std::ldexp(static_cast<double>(exact), -30);
      EXPECT_EQ(sum_of(terms), expected);
      EXPECT_EQ(reversed_sum_of(terms), expected);
      std::shuffle(terms.begin(), terms.end(), random);
      EXPECT_EQ(sum_of(terms), expected);
    }

    // As many terms of one sign as could fill a chunk if carries were forgotten.
    TEST(ExactSum, CarriesInTime)
    {
      const double full = std::ldexp(std::ldexp(1., 53) - 1., -22); // 53 bits, as high in a chunk as they go
      for (const double term : {full, -full})
        {
          ExactSum sum;
          for (int i = 0; i < 1 << 20; ++i)
            sum.add(term);
          EXPECT_EQ(sum.value(), 0x1p20 * term);
        }
    }

    TEST(ExactSum, IsNoNumberWithATermThatIsNone)
    {
      constexpr double infinite = std::numeric_limits<double>::infinity();
      for (const double term : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_TRUE(std::isnan(sum_of({1., term, 2.})));
      EXPECT_TRUE(std::isnan(sum_of({infinite, -infinite})));
    }

    TEST(ExactSum, ReducesToItselfOnOneRank)
    {
      std::array<ExactSum, 3> sums;
      sums[0].add(-0.1);
      sums[0].add(1e-200);
      sums[1].add(1e300);
      sums[2].add(std::numeric_limits<double>::infinity());
      ExactSum::reduce(sums, MPI_COMM_SELF);
      EXPECT_EQ(sums[0].value(), -0.1);
      EXPECT_EQ(sums[1].value(), 1e300);
      EXPECT_TRUE(std::isnan(sums[2].value()));
      sums[0].add(0.1);
      EXPECT_EQ(sums[0].value(), 1e-200) << "goes on after a reduction";
    }
  } // namespace
} // namespace whipple
