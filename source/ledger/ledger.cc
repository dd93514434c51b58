// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/ledger/ledger.h>

#include <cmath>
#include <sstream>

namespace whipple
{
  namespace
  {
    /// Velocity, cm/us, that is nothing: a problem in which all moves no faster (1 cm/s) has no other scale.
    constexpr double slow = 1e-6;

    /// The size of a difference as a part of a scale; itself where there is none.
    double
    relative(double difference, double scale)
    {
      return std::abs(scale > 0 ? difference / scale : difference);
    }
  } // namespace

  template <int dim>
  void
  Ledger<dim>::introduce(const ConservedTotals<dim> &amounts)
  {
    books_.introduced += amounts;
    books_.momentum_scale += std::sqrt(2. * amounts.mass * amounts.kinetic_energy);
  }

  template <int dim>
  void
  Ledger<dim>::enter(const std::string &cause, const Booking<dim> &booking)
  {
    Booking<dim> happened = booking;
    if (happened.event && happened.event->number == 0)
      happened.event.reset();
    if (happened.left)
      books_.left += *happened.left;
    if (happened.left || happened.dropped || happened.converted || happened.event)
      books_.bookings.enter(cause, happened);
  }

  template <int dim>
  void
  Ledger<dim>::enter(const Bookings<dim> &bookings)
  {
    for (const auto &[cause, booking] : bookings.by_cause())
      enter(cause, booking);
  }

  template <int dim>
  void
  Ledger<dim>::note(const std::string &cause, double number, double size, const std::string &unit)
  {
    enter(cause, {.event = Event{number, size, unit}});
  }

  template <int dim>
  ConservedTotals<dim>
  Ledger<dim>::gone() const
  {
    ConservedTotals<dim> sum = books_.left;
    for (const auto &[cause, booking] : books_.bookings.by_cause())
      if (booking.dropped)
        sum += *booking.dropped;
    return sum;
  }

  template <int dim>
  double
  Ledger<dim>::energy_scale() const
  {
    // pistons bring in more than bodies at rest; matter that enters compressed and without energy makes kinetic energy
    // out of negative internal energy; of bodies at rest round-off alone moves anything
    return std::max({books_.introduced.kinetic_energy, std::abs(books_.introduced.internal_energy), books_.energy_seen,
                     std::abs(gone().total_energy()), books_.introduced.mass * slow * slow});
  }

  template <int dim>
  typename Ledger<dim>::Closure
  Ledger<dim>::imbalance(const ConservedTotals<dim> &present) const
  {
    const ConservedTotals<dim> gone = this->gone();
    return {present.mass + gone.mass - books_.introduced.mass,
            present.momentum[axial] + gone.momentum[axial] - books_.introduced.momentum[axial],
            present.total_energy() + gone.total_energy() - books_.introduced.total_energy()};
  }

  template <int dim>
  typename Ledger<dim>::Closure
  Ledger<dim>::scale() const
  {
    // bodies at rest that gas or deposited energy sets in motion have no momentum scale but that of the energy
    const double energy = energy_scale(), mass = books_.introduced.mass;
    return {mass, std::max(books_.momentum_scale, std::sqrt(2. * mass * energy)), energy};
  }

  template <int dim>
  typename Ledger<dim>::Closure
  Ledger<dim>::closure(const ConservedTotals<dim> &present) const
  {
    const Closure difference = imbalance(present), scale = this->scale();
    return {relative(difference.mass, scale.mass), relative(difference.axial_momentum, scale.axial_momentum),
            relative(difference.energy, scale.energy)};
  }

  template <int dim>
  void
  Ledger<dim>::check(const ConservedTotals<dim> &present, const std::string &event, double tolerance)
  {
    books_.energy_seen = std::max({books_.energy_seen, present.kinetic_energy, std::abs(present.internal_energy)});
    const Closure now = imbalance(present), scale = this->scale();
    const auto    judge = [&](const char *quantity, double change, double measure) {
      if (relative(change, measure) <= tolerance) // false for what is not a number
        return;
      std::ostringstream text;
      text.precision(3);
      text << std::scientific << event << " changed the " << quantity << " of the problem by "
           << (measure > 0 ? change / measure : change) << " of its scale, allowed is " << tolerance;
      throw ConservationError(text.str());
    };
    judge("mass", now.mass - books_.last.mass, scale.mass);
    judge("axial momentum", now.axial_momentum - books_.last.axial_momentum, scale.axial_momentum);
    judge("total energy", now.energy - books_.last.energy, scale.energy);
    books_.last = now;
  }

  template class Ledger<2>;
} // namespace whipple
