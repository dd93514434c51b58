// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/state/bookings.h>

#include <map>
#include <string>
#include <vector>

namespace whipple
{
  /// What an effect may enter under a cause.
  enum class BookingKind
  {
    converts, ///< energy that changed its form or its cell, and is still there
    leaves,   ///< what left the problem; what came in from outside is negative
    drops,    ///< what was taken out on purpose
    notes     ///< an event: something that had to be done, how often, and how much in all
  };

  /// A cause under which an effect enters what it changes; declared beside its code.
  struct BookingDescription
  {
    BookingKind kind;
    std::string cause;         ///< in the log and summary.json
    std::string documentation; ///< what the amount is
    std::string unit = {};     ///< of the size of an event
  };

  /// What the effects of one rank do in a step, under the causes that they have declared. All causes are there on all
  /// ranks, so that the sum over the ranks needs one message. No entry is made per cell: an effect adds up its owned
  /// cells first.
  template <int dim>
  class EffectBooks
  {
  public:
    EffectBooks() = default;
    explicit EffectBooks(const std::vector<BookingDescription> &causes);

    /// Add to what is entered under a cause: energy [Mbar cm^3]; amounts; a number of events and their size.
    /// @throws std::logic_error if no effect that is on has declared the cause as of this kind
    void
    convert(const std::string &cause, double energy);
    void
    leave(const std::string &cause, const ConservedTotals<dim> &amounts);
    void
    drop(const std::string &cause, const ConservedTotals<dim> &amounts);
    void
    note(const std::string &cause, double number, double size);

    /// Begin a step: nothing has been done yet.
    void
    clear();

    /// What this rank has done in the step, every declared cause among it.
    Bookings<dim>
    bookings() const;

  private:
    struct Entry
    {
      BookingDescription description;
      Booking<dim>       booking;
    };

    Booking<dim> &
    booking(BookingKind kind, const std::string &cause);

    std::map<std::string, Entry> entries_; ///< by cause
  };
} // namespace whipple
