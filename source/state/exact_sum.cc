// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/state/exact_sum.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace whipple
{
  namespace
  {
    /// Of the smallest double that is not zero.
    constexpr int smallest_exponent = -1074;
  } // namespace

  void
  ExactSum::carry()
  {
    std::int64_t carried = 0;
    for (int i = 0; i + 1 < n_chunks; ++i)
      {
        const std::int64_t full = chunk_[i] + carried;
        carried                 = full >> chunk_bits; // towards minus infinity
        chunk_[i]               = full & static_cast<std::int64_t>(chunk_mask);
      }
    chunk_[n_chunks - 1] += carried;
    waiting_ = 0;
  }

  void
  ExactSum::add(const ExactSum &other)
  {
    ExactSum carried = other;
    carried.carry();
    carry(); // both below 2^32 in each chunk now
    for (int i = 0; i < n_chunks; ++i)
      chunk_[i] += carried.chunk_[i];
    not_finite_ += carried.not_finite_;
    carry();
  }

  double
  ExactSum::value() const
  {
    if (not_finite_ > 0)
      return std::numeric_limits<double>::quiet_NaN();
    ExactSum sum = *this;
    sum.carry();
    const bool negative = sum.chunk_[n_chunks - 1] < 0;
    if (negative)
      {
        for (std::int64_t &chunk : sum.chunk_)
          chunk = -chunk;
        sum.carry();
      }
    int top = n_chunks - 1;
    while (top > 0 && sum.chunk_[top] == 0)
      --top;
    const auto part = [&](int i) { return i >= 0 ? static_cast<std::uint64_t>(sum.chunk_[i]) : 0; };
    if (part(top) > chunk_mask)
      return negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    if (part(top) == 0)
      return 0.;

    // the leading 64 bits, from the highest that is set; of what lies below it only counts whether it is zero
    const int           shift   = std::countl_zero(part(top)) - static_cast<int>(chunk_bits);
    const std::uint64_t below   = part(top - 2) << shift;
    const std::uint64_t leading = (((part(top) << chunk_bits) | part(top - 1)) << shift) | (below >> chunk_bits);
    bool                rest    = (below & chunk_mask) != 0;
    for (int i = top - 3; i >= 0 && !rest; --i)
      rest = sum.chunk_[i] != 0;

    // bit 63 of leading is worth 2^exponent; a double holds 53 bits, fewer below 2^-1022
    const int           exponent = smallest_exponent + static_cast<int>(chunk_bits) * (top + 1) - 1 - shift;
    const int           dropped  = 11 + std::max(-1022 - exponent, 0);
    std::uint64_t       kept     = leading >> dropped;
    const std::uint64_t half     = std::uint64_t{1} << (dropped - 1);
    const std::uint64_t beyond   = leading & (2 * half - 1);
    if (beyond > half || (beyond == half && (rest || kept % 2 == 1)))
      ++kept;
    const double magnitude = std::ldexp(static_cast<double>(kept), exponent - 63 + dropped);
    return negative ? -magnitude : magnitude;
  }

  void
  ExactSum::reduce(std::span<ExactSum> sums, MPI_Comm communicator)
  {
    // carried chunks are below 2^32: two thousand million ranks cannot make one overflow
    constexpr std::size_t     length = n_chunks + 1;
    std::vector<std::int64_t> buffer;
    buffer.reserve(sums.size() * length);
    for (ExactSum &sum : sums)
      {
        sum.carry();
        buffer.insert(buffer.end(), sum.chunk_.begin(), sum.chunk_.end());
        buffer.push_back(sum.not_finite_);
      }
    MPI_Allreduce(MPI_IN_PLACE, buffer.data(), static_cast<int>(buffer.size()), MPI_INT64_T, MPI_SUM, communicator);
    for (std::size_t i = 0; i < sums.size(); ++i)
      {
        const auto begin = buffer.begin() + static_cast<std::ptrdiff_t>(i * length);
        std::copy(begin, begin + n_chunks, sums[i].chunk_.begin());
        sums[i].not_finite_ = begin[n_chunks];
        sums[i].carry();
      }
  }
} // namespace whipple
