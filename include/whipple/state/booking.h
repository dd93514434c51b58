// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/state/conserved_totals.h>
#include <whipple/state/kinetic_loss.h>

#include <optional>
#include <string>

namespace whipple
{
  /// Something the scheme had to do to go on (a squeeze, a merge, a release ...): how often, and how much in all.
  struct Event
  {
    double      number = 0;
    double      size   = 0;
    std::string unit; ///< of size, "g", "Mbar cm^3" ...
  };

  /// What one cause did to what a problem holds. What it cannot do has no value.
  template <int dim>
  struct Booking
  {
    std::optional<ConservedTotals<dim>> left{};      ///< crossed the sides of the domain, or was given to them
    std::optional<ConservedTotals<dim>> dropped{};   ///< taken out on purpose
    std::optional<double>               converted{}; ///< energy that only changed its form, Mbar cm^3
    std::optional<Event>                event{};

    Booking &
    operator+=(const Booking &other)
    {
      const auto add = [](auto &mine, const auto &theirs) {
        if (theirs)
          (mine ? *mine : mine.emplace()) += *theirs;
      };
      add(left, other.left);
      add(dropped, other.dropped);
      add(converted, other.converted);
      if (other.event)
        {
          Event &mine = event ? *event : event.emplace();
          mine.number += other.event->number;
          mine.size += other.event->size;
          mine.unit = other.event->unit;
        }
      return *this;
    }
  };

  /// Kinetic energy [Mbar cm^3] that averaging velocities took: converted; where it heats no material it is dropped,
  /// too.
  template <int dim>
  Booking<dim>
  lost_kinetic_energy(double energy, KineticLoss loss)
  {
    Booking<dim> booking;
    booking.converted = energy;
    if (loss == KineticLoss::drop)
      booking.dropped.emplace().kinetic_energy = energy;
    return booking;
  }
} // namespace whipple
