// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/totals.h>
#include <whipple/state/bookings.h>

#include <string>
#include <utility>

namespace whipple
{
  /// Books of a run: what came in, what left through the domain's sides, what was dropped and why. What is
  /// present must be the difference, to round-off, after every step, regrid and projection:
  ///
  ///     present = introduced - left - dropped        for mass, axial momentum and total energy
  template <int dim>
  class Ledger
  {
  public:
    /// Axis along which momentum is conserved in both symmetries.
    static constexpr int axial = flight_axis<dim>;

    /// |present - books| relative to the scale of the quantity, or itself.
    struct Closure
    {
      double mass = 0, axial_momentum = 0, energy = 0;
    };

    /// All that has been entered.
    struct Books
    {
      ConservedTotals<dim> introduced;
      double               momentum_scale = 0; ///< sum of sqrt(2 m T) of what was introduced
      ConservedTotals<dim> left;               ///< by all causes together, in the order in which it left
      Bookings<dim>        bookings;
      double  energy_seen = 0; ///< largest kinetic energy, or size of the internal one, at any check, Mbar cm^3
      Closure last;            ///< imbalance at the last check: g, g cm/us, Mbar cm^3
    };

    Ledger() = default;
    /// Go on with books kept before.
    explicit Ledger(Books books)
      : books_(std::move(books))
    {
    }
    const Books &
    books() const
    {
      return books_;
    }

    void
    introduce(const ConservedTotals<dim> &amounts);

    /// Enter what pieces of the scheme did, all ranks together. An event that never happened is left out.
    void
    enter(const Bookings<dim> &bookings);
    void
    enter(const std::string &cause, const Booking<dim> &booking);

    /// Count what the scheme had to do, all ranks together. Nothing is entered if it never happened.
    void
    note(const std::string &cause, double number, double size, const std::string &unit);

    /// Compare the books with what is present.
    /// @param tolerance largest allowed change of the imbalance since the last call, relative to the mass
    ///                  introduced, to energy_scale(), and to the momentum that belongs to them
    /// @throws ConservationError naming the event, the quantity and the numbers.
    void
    check(const ConservedTotals<dim> &present, const std::string &event, double tolerance);

    /// |present - books| relative to the scale of the quantity.
    Closure
    closure(const ConservedTotals<dim> &present) const;

    /// What energies of the problem are to be measured by: the largest of the kinetic and internal energy introduced
    /// and of those that were present at a check, of what has gone, and of the introduced mass at 1 cm/s, Mbar cm^3.
    double
    energy_scale() const;

    const ConservedTotals<dim> &
    introduced() const
    {
      return books_.introduced;
    }
    const ConservedTotals<dim> &
    left() const
    {
      return books_.left;
    }
    /// By cause: what left, was dropped or changed its form, and events.
    const Bookings<dim> &
    bookings() const
    {
      return books_.bookings;
    }

  private:
    /// What has left or was dropped.
    ConservedTotals<dim>
    gone() const;

    /// present - (introduced - left - dropped).
    Closure
    imbalance(const ConservedTotals<dim> &present) const;

    /// What a difference is measured by.
    Closure
    scale() const;

    Books books_;
  };
} // namespace whipple
