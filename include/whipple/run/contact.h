// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/run/domain.h>

#include <algorithm>
#include <limits>

namespace whipple
{
  /// What a look at contacts found and did, all ranks.
  template <int dim>
  struct ContactLook
  {
    long          elements = 0;   ///< that hold mass
    long          joined   = 0;   ///< elements that took the velocity of their cluster
    long          clusters = 0;   ///< of them
    long          deep     = 0;   ///< elements whose middle lies deep in solid of others
    double        time_to_next{}; ///< us in which approaching elements come no closer than a look should see
    Bookings<dim> bookings;       ///< "contact": kinetic energy lost by joining, impulse given to walls; and the event
  };

  /// Find elements of a Lagrangian mesh that lie in one another and join those that approach
  /// (doc/theory/projection.md). Two elements are in contact when the middle of one lies inside the other and the solid
  /// there, sum of (1 - phi) over the elements around that point, exceeds 1: neighbours that only touch are not, nor
  /// are thin clouds that pass through each other. Elements connected by contacts that do not open form a cluster;
  /// where any of them approaches, all corners of the cluster take its mean velocity (along directions in which an
  /// element is held by the axis or a reflecting side: zero). Momentum is kept; the kinetic energy lost heats the
  /// cluster, the same per gram. Nodes that an element shares with others outside the cluster take the mean by mass
  /// (gather_velocities). Collective; the same bits on any number of ranks. Elements go to the ranks that own the bins
  /// they touch; every rank learns of the elements in contact, not of the others.
  template <int dim>
  ContactLook<dim>
  join_contacts(const Boundaries<dim> &boundaries, KineticLoss loss, Domain<dim> &domain);

  /// When to look for contacts. The first look is due at once.
  class ContactSchedule
  {
  public:
    ContactSchedule() = default;
    /// @param next number of steps made at which the next look is due
    /// @param clear_until no approaching elements come near each other before, us
    ContactSchedule(long next, double clear_until)
      : next_(next)
      , clear_until_(clear_until)
    {
    }

    double
    clear_until() const
    {
      return clear_until_;
    }

    long
    next() const
    {
      return next_;
    }

    /// @param step number of steps made
    /// @param time now, us
    bool
    due(long step, double time) const
    {
      return step >= next_ || time >= clear_until_;
    }

    /// @param dt the present time step, us
    template <int dim>
    void
    looked(long step, double time, double dt, const ContactLook<dim> &look)
    {
      clear_until_       = time + std::max(look.time_to_next, dt);
      const double steps = look.time_to_next / dt;
      next_              = step + (!(steps >= 1.) ? 1 : steps < most_steps ? static_cast<long>(steps) : most_steps);
    }

  private:
    static constexpr long most_steps = 20;

    long   next_        = 0;
    double clear_until_ = -std::numeric_limits<double>::infinity(); ///< us
  };

  /// Whether joining has failed: so many elements lie deep in others that the state is no longer one of matter.
  template <int dim>
  bool
  overlap_is_deep(const ContactLook<dim> &look)
  {
    constexpr double share = 0.02;
    constexpr long   least = 8;
    return look.deep >= least && static_cast<double>(look.deep) > share * static_cast<double>(look.elements);
  }
} // namespace whipple
