// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/effect_books.h>

#include <stdexcept>

namespace whipple
{
  namespace
  {
    template <int dim>
    Booking<dim>
    nothing(const BookingDescription &cause)
    {
      switch (cause.kind)
        {
        case BookingKind::converts:
          return {.converted = 0.};
        case BookingKind::leaves:
          return {.left = ConservedTotals<dim>{}};
        case BookingKind::drops:
          return {.dropped = ConservedTotals<dim>{}};
        case BookingKind::notes:
          break;
        }
      return {.event = Event{0, 0, cause.unit}};
    }
  } // namespace

  template <int dim>
  EffectBooks<dim>::EffectBooks(const std::vector<BookingDescription> &causes)
  {
    for (const BookingDescription &cause : causes)
      if (!entries_.emplace(cause.cause, Entry{cause, nothing<dim>(cause)}).second)
        throw std::logic_error("two effects enter under '" + cause.cause + "'");
  }

  template <int dim>
  Booking<dim> &
  EffectBooks<dim>::booking(BookingKind kind, const std::string &cause)
  {
    const auto found = entries_.find(cause);
    if (found == entries_.end() || found->second.description.kind != kind)
      throw std::logic_error("no effect that is on declares such a booking under '" + cause + "'");
    return found->second.booking;
  }

  template <int dim>
  void
  EffectBooks<dim>::convert(const std::string &cause, double energy)
  {
    *booking(BookingKind::converts, cause).converted += energy;
  }

  template <int dim>
  void
  EffectBooks<dim>::leave(const std::string &cause, const ConservedTotals<dim> &amounts)
  {
    *booking(BookingKind::leaves, cause).left += amounts;
  }

  template <int dim>
  void
  EffectBooks<dim>::drop(const std::string &cause, const ConservedTotals<dim> &amounts)
  {
    *booking(BookingKind::drops, cause).dropped += amounts;
  }

  template <int dim>
  void
  EffectBooks<dim>::note(const std::string &cause, double number, double size)
  {
    Event &event = *booking(BookingKind::notes, cause).event;
    event.number += number;
    event.size += size;
  }

  template <int dim>
  void
  EffectBooks<dim>::clear()
  {
    for (auto &[cause, entry] : entries_)
      entry.booking = nothing<dim>(entry.description);
  }

  template <int dim>
  Bookings<dim>
  EffectBooks<dim>::bookings() const
  {
    Bookings<dim> all;
    for (const auto &[cause, entry] : entries_)
      all.enter(cause, entry.booking);
    return all;
  }

  template class EffectBooks<2>;
} // namespace whipple
