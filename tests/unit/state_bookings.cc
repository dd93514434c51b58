// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/ledger/ledger.h>
#include <whipple/remap/remap_sums.h>
#include <whipple/state/bookings.h>

#include <gtest/gtest.h>

namespace
{
  using namespace whipple;

  Bookings<2>
  two_causes()
  {
    Bookings<2> bookings;
    bookings.drop("void cutoff", {.mass = 2., .momentum = {{0., 3.}}, .internal_energy = 5., .kinetic_energy = 7.});
    bookings.enter("regrid", lost_kinetic_energy<2>(0.25, KineticLoss::drop));
    bookings.note("squeezed", 3., 0.5, "cm^3");
    return bookings;
  }

  TEST(Bookings, OneCauseAddsUpAndOthersStay)
  {
    Bookings<2> sum = two_causes();
    sum += two_causes();
    sum.leave("regrid", {.mass = 1.});
    ASSERT_EQ(sum.by_cause().size(), 3u);
    const Booking<2> regrid = sum.of("regrid");
    EXPECT_EQ(*regrid.converted, 0.5);
    EXPECT_EQ(regrid.dropped->kinetic_energy, 0.5);
    EXPECT_EQ(regrid.left->mass, 1.);
    EXPECT_FALSE(regrid.event.has_value());
    EXPECT_EQ(sum.of("squeezed").event->number, 6.);
    EXPECT_EQ(sum.of("squeezed").event->size, 1.);
    EXPECT_EQ(sum.of("squeezed").event->unit, "cm^3");
    EXPECT_EQ(sum.of("void cutoff").dropped->momentum[1], 6.);
    EXPECT_FALSE(sum.of("nothing of the kind").dropped.has_value());
  }

  TEST(Bookings, HeatIsNotDropped)
  {
    EXPECT_FALSE(lost_kinetic_energy<2>(0.25, KineticLoss::heat).dropped.has_value());
    EXPECT_EQ(*lost_kinetic_energy<2>(0.25, KineticLoss::heat).converted, 0.25);
  }

  // 10 g at 2 cm/us with 6 Mbar cm^3 of heat; 2 g with 3 g cm/us are cut off, 0.25 Mbar cm^3 is lost, and 1 g leaves.
  TEST(Bookings, TheLedgerClosesOverAllCauses)
  {
    Ledger<2> ledger;
    ledger.introduce({.mass = 10., .momentum = {{0., 20.}}, .internal_energy = 6., .kinetic_energy = 20.});
    Bookings<2> bookings = two_causes();
    bookings.leave("sides of the domain", {.mass = 1., .momentum = {{0., 2.}}, .internal_energy = 0.5});
    bookings.enter("never", {.event = Event{0., 1., "g"}});
    ledger.enter(bookings);
    const ConservedTotals<2> present{
        .mass = 7., .momentum = {{0., 15.}}, .internal_energy = 0.5, .kinetic_energy = 12.75};
    const auto closure = ledger.closure(present);
    EXPECT_EQ(closure.mass, 0.);
    EXPECT_EQ(closure.axial_momentum, 0.);
    EXPECT_EQ(closure.energy, 0.);
    EXPECT_EQ(ledger.bookings().by_cause().count("never"), 0u);
    EXPECT_EQ(ledger.bookings().of("squeezed").event->number, 3.);
  }

  TEST(Bookings, OfARemapAreTheSumOverTheSidesAndWhatWasLost)
  {
    RemapSums<2> sums;
    sums.side[0]          = {1., {{2., 3.}}, 4., 5.};
    sums.side[3]          = {-0.25, {{0., 1.}}, 1., 2.};
    sums.kinetic_lost     = 0.5;
    sums.cells_compressed = 2;
    sums.compressed.add(1e-9);
    const Bookings<2> bookings = sums.bookings(KineticLoss::drop);
    const auto        left     = bookings.of("sides of the domain").left.value();
    EXPECT_EQ(left.mass, 0.75);
    EXPECT_EQ(left.momentum[1], 4.);
    EXPECT_EQ(left.kinetic_energy, 5.);
    EXPECT_EQ(left.internal_energy, 7.);
    EXPECT_EQ(*bookings.of("remap").converted, 0.5);
    EXPECT_EQ(bookings.of("remap").dropped->kinetic_energy, 0.5);
    EXPECT_EQ(bookings.of("overfull cells compressed").event->number, 2.);
    EXPECT_EQ(bookings.of("overfull cells compressed").event->size, 1e-9);
  }
} // namespace
