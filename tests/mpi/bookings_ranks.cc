// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/state/bookings.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  TEST(BookingsOnRanks, AddUpNumberByNumber)
  {
    int rank = 0, size = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    Bookings<2> own;
    own.leave("sides", {.mass = 1. + rank, .momentum = {{0., 2.}}, .internal_energy = 3., .kinetic_energy = -4.});
    own.convert("remap", 0.5 * rank);
    own.enter("squeezed", {.event = Event{static_cast<double>(rank), 1., "g"}});
    const Bookings<2> all   = sum_over_ranks(own, MPI_COMM_WORLD);
    const double      ranks = size, sum = 0.5 * size * (size - 1);
    EXPECT_EQ(all.of("sides").left->mass, ranks + sum);
    EXPECT_EQ(all.of("sides").left->momentum[1], 2. * ranks);
    EXPECT_EQ(all.of("sides").left->internal_energy, 3. * ranks);
    EXPECT_EQ(all.of("sides").left->kinetic_energy, -4. * ranks);
    EXPECT_EQ(*all.of("remap").converted, 0.5 * sum);
    EXPECT_EQ(all.of("squeezed").event->number, sum);
    EXPECT_EQ(all.of("squeezed").event->size, ranks);
    EXPECT_EQ(all.of("squeezed").event->unit, "g");
  }
} // namespace
