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
  Ledger<dim>::leave(const std::string &cause, const ConservedTotals<dim> &amounts)
  {
    enter(cause, {.left = amounts});
  }

  template <int dim>
  void
  Ledger<dim>::drop(const std::string &cause, const ConservedTotals<dim> &amounts)
  {
    enter(cause, {.dropped = amounts});
  }

  template <int dim>
  void
  Ledger<dim>::convert(const std::string &cause, double energy)
  {
    enter(cause, {.converted = energy});
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
    // pistons bring in more than bodies at rest; of bodies at rest round-off alone moves anything
    return std::max({books_.introduced.kinetic_energy, std::abs(books_.introduced.internal_energy),
                     std::abs(gone().total_energy()), books_.introduced.mass * slow * slow});
  }

  template <int dim>
  typename Ledger<dim>::Closure
  Ledger<dim>::imbalance(const ConservedTotals<dim> &present) const
  {
    const ConservedTotals<dim> gone = this->gone();
    const auto relative = [](double difference, double scale) { return scale > 0 ? difference / scale : difference; };
    Closure    result;
    result.mass = relative(present.mass + gone.mass - books_.introduced.mass, books_.introduced.mass);
    // bodies at rest that gas or deposited energy sets in motion have no momentum scale but that of the energy
    const double momentum_scale =
        std::max(books_.momentum_scale, std::sqrt(2. * books_.introduced.mass * energy_scale()));
    result.axial_momentum =
        relative(present.momentum[axial] + gone.momentum[axial] - books_.introduced.momentum[axial], momentum_scale);
    result.energy =
        relative(present.total_energy() + gone.total_energy() - books_.introduced.total_energy(), energy_scale());
    return result;
  }

  template <int dim>
  typename Ledger<dim>::Closure
  Ledger<dim>::closure(const ConservedTotals<dim> &present) const
  {
    Closure result        = imbalance(present);
    result.mass           = std::abs(result.mass);
    result.axial_momentum = std::abs(result.axial_momentum);
    result.energy         = std::abs(result.energy);
    return result;
  }

  template <int dim>
  void
  Ledger<dim>::check(const ConservedTotals<dim> &present, const std::string &event, double tolerance)
  {
    const Closure now   = imbalance(present);
    const auto    judge = [&](const char *quantity, double before, double after) {
      if (std::abs(after - before) <= tolerance) // false for what is not a number
        return;
      std::ostringstream text;
      text.precision(3);
      text << std::scientific << event << " changed the " << quantity << " of the problem by " << after - before
           << " of what was introduced, allowed is " << tolerance;
      throw ConservationError(text.str());
    };
    judge("mass", books_.last.mass, now.mass);
    judge("axial momentum", books_.last.axial_momentum, now.axial_momentum);
    judge("total energy", books_.last.energy, now.energy);
    books_.last = now;
  }

  template class Ledger<2>;
} // namespace whipple
