// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/state/bookings.h>

#include <vector>

namespace whipple
{
  namespace
  {
    /// Call with each number of a booking that adds up over the ranks.
    template <int dim, typename Visit>
    void
    for_numbers(Booking<dim> &booking, const Visit &visit)
    {
      for (auto *amounts : {&booking.left, &booking.dropped})
        if (*amounts)
          {
            visit((*amounts)->mass);
            for (double &component : (*amounts)->momentum)
              visit(component);
            visit((*amounts)->internal_energy);
            visit((*amounts)->kinetic_energy);
          }
      if (booking.converted)
        visit(*booking.converted);
      if (booking.event)
        {
          visit(booking.event->number);
          visit(booking.event->size);
        }
    }

    /// @param bookings the same ones on all ranks
    template <int dim>
    void
    add_over_ranks(const std::vector<Booking<dim> *> &bookings, MPI_Comm communicator)
    {
      std::vector<double> numbers;
      for (Booking<dim> *booking : bookings)
        for_numbers(*booking, [&](double value) { numbers.push_back(value); });
      MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, MPI_SUM, communicator);
      auto next = numbers.begin();
      for (Booking<dim> *booking : bookings)
        for_numbers(*booking, [&](double &value) { value = *next++; });
    }
  } // namespace

  template <int dim>
  void
  Bookings<dim>::enter(const std::string &cause, const Booking<dim> &booking)
  {
    booking_[cause] += booking;
  }

  template <int dim>
  void
  Bookings<dim>::leave(const std::string &cause, const ConservedTotals<dim> &amounts)
  {
    enter(cause, {.left = amounts});
  }

  template <int dim>
  void
  Bookings<dim>::drop(const std::string &cause, const ConservedTotals<dim> &amounts)
  {
    enter(cause, {.dropped = amounts});
  }

  template <int dim>
  void
  Bookings<dim>::convert(const std::string &cause, double energy)
  {
    enter(cause, {.converted = energy});
  }

  template <int dim>
  void
  Bookings<dim>::note(const std::string &cause, double number, double size, const std::string &unit)
  {
    if (number != 0)
      enter(cause, {.event = Event{number, size, unit}});
  }

  template <int dim>
  Bookings<dim> &
  Bookings<dim>::operator+=(const Bookings &other)
  {
    for (const auto &[cause, booking] : other.booking_)
      enter(cause, booking);
    return *this;
  }

  template <int dim>
  Booking<dim>
  Bookings<dim>::of(const std::string &cause) const
  {
    const auto found = booking_.find(cause);
    return found == booking_.end() ? Booking<dim>{} : found->second;
  }

  template <int dim>
  Bookings<dim>
  sum_over_ranks(const Bookings<dim> &own, MPI_Comm communicator)
  {
    std::map<std::string, Booking<dim>> all = own.by_cause();
    std::vector<Booking<dim> *>         bookings;
    for (auto &[cause, booking] : all)
      bookings.push_back(&booking);
    add_over_ranks(bookings, communicator);
    Bookings<dim> result;
    for (const auto &[cause, booking] : all)
      result.enter(cause, booking);
    return result;
  }

  template <int dim>
  Booking<dim>
  sum_over_ranks(const Booking<dim> &own, MPI_Comm communicator)
  {
    Booking<dim> all = own;
    add_over_ranks<dim>({&all}, communicator);
    return all;
  }

  template class Bookings<2>;
  template Bookings<2>
  sum_over_ranks(const Bookings<2> &, MPI_Comm);
  template Booking<2>
  sum_over_ranks(const Booking<2> &, MPI_Comm);
} // namespace whipple
