// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/state/booking.h>

#include <mpi.h>

#include <map>
#include <string>

namespace whipple
{
  /// What pieces of the scheme did to what a problem holds, by cause, for the ledger: the only form in which they hand
  /// it over. The ledger, the log and the summary go through the causes there are, whatever they are called.
  ///
  /// A cause is a few words that name it in the log: "remap", "void cutoff", "overfull cells compressed".
  template <int dim>
  class Bookings
  {
  public:
    /// Enter what one cause did; what it did before stays.
    void
    enter(const std::string &cause, const Booking<dim> &booking);

    /// Crossed the sides of the domain, or was given to them (work and impulse).
    void
    leave(const std::string &cause, const ConservedTotals<dim> &amounts);

    /// Taken out on purpose.
    void
    drop(const std::string &cause, const ConservedTotals<dim> &amounts);

    /// Energy [Mbar cm^3] that only changed its form.
    void
    convert(const std::string &cause, double energy);

    /// Something that the scheme had to do to go on. Nothing is entered if it never happened.
    void
    note(const std::string &cause, double number, double size, const std::string &unit);

    Bookings &
    operator+=(const Bookings &other);

    /// By name, in alphabetical order.
    const std::map<std::string, Booking<dim>> &
    by_cause() const
    {
      return booking_;
    }

    /// What one cause did; nothing if it did nothing.
    Booking<dim>
    of(const std::string &cause) const;

  private:
    std::map<std::string, Booking<dim>> booking_;
  };

  /// The bookings of all ranks together. The causes, and what is booked of each, must be the same on all of them.
  template <int dim>
  Bookings<dim>
  sum_over_ranks(const Bookings<dim> &own, MPI_Comm communicator);
  template <int dim>
  Booking<dim>
  sum_over_ranks(const Booking<dim> &own, MPI_Comm communicator);
} // namespace whipple
