// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace whipple
{
  /// A sum of doubles in 128-bit fixed point: integers add in any order to the same bits, so totals do not
  /// depend on how cells are spread over ranks. Resolution 2^-90 (8e-28); a term of 2^36 or more in the field's
  /// units, or one that is not a number, makes the sum not a number.
  class ExactSum
  {
  public:
    void
    add(double value)
    {
      if (std::abs(value) < bound)
        sum_ += static_cast<__int128>(value * scale);
      else
        ++unrepresentable_;
    }

    double
    value() const
    {
      return unrepresentable_ ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(sum_) / scale;
    }

    /// Replace every sum by its total over the ranks.
    static void
    reduce(std::span<ExactSum> sums, MPI_Comm communicator)
    {
      // three limbs of 44 bits leave room for the carries of half a million ranks
      constexpr int             bits = 44;
      std::vector<std::int64_t> limb;
      for (const ExactSum &s : sums)
        {
          __int128 rest = s.sum_;
          for (int i = 0; i < 2; ++i)
            {
              limb.push_back(static_cast<std::int64_t>(rest & ((std::int64_t{1} << bits) - 1)));
              rest >>= bits;
            }
          limb.push_back(static_cast<std::int64_t>(rest));
          limb.push_back(s.unrepresentable_);
        }
      MPI_Allreduce(MPI_IN_PLACE, limb.data(), static_cast<int>(limb.size()), MPI_INT64_T, MPI_SUM, communicator);
      for (std::size_t i = 0; i < sums.size(); ++i)
        {
          const std::int64_t *l    = &limb[4 * i];
          sums[i].sum_             = (((static_cast<__int128>(l[2]) << bits) + l[1]) << bits) + l[0];
          sums[i].unrepresentable_ = l[3];
        }
    }

  private:
    static constexpr double scale = 0x1p90, bound = 0x1p36;
    __int128                sum_             = 0;
    std::int64_t            unrepresentable_ = 0;
  };
} // namespace whipple
