// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <mpi.h>

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace whipple
{
  /// The exact sum of doubles of any size: a fixed-point number that reaches from the smallest double to beyond the
  /// largest, kept in chunks of 32 bits that overlap in 64-bit integers so that carries wait (the "small
  /// superaccumulator" of [Neal2015]). Integers add in any order to the same bits: totals depend neither on the order
  /// of cells nor on how they are spread over ranks, and have no scale of their own. Up to 2^63 terms.
  class ExactSum
  {
  public:
    /// Add a term; one that is not finite makes the sum not a number.
    void
    add(double value)
    {
      const auto         bits     = std::bit_cast<std::uint64_t>(value);
      const unsigned     exponent = (bits >> mantissa_bits) & 0x7ff;
      const std::int64_t negative = -static_cast<std::int64_t>(bits >> 63); // all bits set if so
      std::uint64_t      mantissa = bits & ((std::uint64_t{1} << mantissa_bits) - 1);
      if (exponent == 0x7ff)
        {
          ++not_finite_;
          return;
        }
      // value = mantissa 2^place in units of the smallest double; without an exponent the leading bit is not implied
      const unsigned place = exponent == 0 ? 0 : exponent - 1;
      mantissa |= std::uint64_t{exponent != 0} << mantissa_bits;
      const unsigned shift = place % chunk_bits;
      const auto     low   = static_cast<std::int64_t>((mantissa << shift) & chunk_mask);
      const auto     high  = static_cast<std::int64_t>(mantissa >> (chunk_bits - shift));
      std::int64_t  *chunk = &chunk_[place / chunk_bits];
      chunk[0] += (low ^ negative) - negative;
      chunk[1] += (high ^ negative) - negative;
      if (++waiting_ == most_waiting)
        carry();
    }

    /// Add all terms of another sum.
    void
    add(const ExactSum &other);

    /// The sum, rounded once to the nearest double (to even if there are two); infinite beyond the largest.
    double
    value() const;

    /// Replace every sum by its total over the ranks.
    static void
    reduce(std::span<ExactSum> sums, MPI_Comm communicator);

  private:
    static constexpr unsigned      mantissa_bits = 52, chunk_bits = 32;
    static constexpr std::uint64_t chunk_mask = (std::uint64_t{1} << chunk_bits) - 1;
    /// Bits from the smallest double (2^-1074) to the largest (below 2^1024), and 63 for as many terms.
    static constexpr int n_chunks = (1074 + 1024 + 63) / static_cast<int>(chunk_bits) + 1;
    /// A chunk starts below 2^32 and each term adds less than 2^52 + 2^32 to it: so many cannot reach 2^63.
    static constexpr int most_waiting = 1 << 10;

    /// Bring every chunk but the last, which has the sign, into [0, 2^32).
    void
    carry();

    std::array<std::int64_t, n_chunks> chunk_{};
    std::int64_t                       not_finite_ = 0;
    int                                waiting_    = 0; ///< terms since the last carry
  };
} // namespace whipple
