// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/ledger/totals.h>
#include <whipple/state/velocity_gather.h>

#include <map>
#include <string>
#include <utility>

namespace whipple
{
  /// Energy that changed its form without leaving the problem, Mbar cm^3, by cause: "viscous work",
  /// "plastic work", "hourglass work", "remap", "regrid", "projection" ...
  using Conversions = std::map<std::string, double>;

  /// Something the scheme had to do to go on (a squeeze, a merge, a release ...): how often, and how much in all.
  struct Event
  {
    double      number = 0;
    double      size   = 0;
    std::string unit; ///< of size, "g", "Mbar cm^3" ...
  };

  /// Books of a run: what came in, what left through the domain's sides, what was dropped and why. What is
  /// present must be the difference, to round-off, after every step, regrid and projection:
  ///
  ///     present = introduced - left - dropped        for mass, axial momentum and total energy
  template <int dim>
  class Ledger
  {
  public:
    /// Axis along which momentum is conserved in both symmetries.
    static constexpr int axial = 1;

    /// |present - books| relative to the scale of the quantity.
    struct Closure
    {
      double mass = 0, axial_momentum = 0, energy = 0;
    };

    /// All that has been entered.
    struct Books
    {
      ConservedTotals<dim>                        introduced;
      double                                      momentum_scale = 0; ///< sum of sqrt(2 m T) of what was introduced
      ConservedTotals<dim>                        left;
      std::map<std::string, ConservedTotals<dim>> dropped;
      Conversions                                 conversions;
      std::map<std::string, Event>                events;
      Closure                                     last; ///< imbalance at the last check
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

    /// Crossed a side of the domain (or, for work and impulse of the sides, was spent on it).
    void
    leave(const ConservedTotals<dim> &amounts);

    void
    drop(const std::string &reason, const ConservedTotals<dim> &amounts);

    void
    convert(const std::string &cause, double energy);

    /// Kinetic energy that averaging velocities lost: converted; where it does not heat the material it is dropped,
    /// too.
    void
    lose_kinetic(const std::string &cause, double energy, KineticLoss loss);

    /// What an averaging of velocities onto nodes did (all ranks): the kinetic energy it lost, and the impulse that
    /// walls took.
    void
    gathered(const std::string &cause, const GatherReport<dim> &report, KineticLoss loss);

    /// Count what the scheme had to do, all ranks together. Nothing is entered if it never happened.
    void
    note(const std::string &what, double number, double size, const std::string &unit);

    /// Compare the books with what is present.
    /// @param tolerance largest allowed change of the imbalance since the last call, relative to what was
    ///                  introduced (mass; axial momentum scale; energy)
    /// @throws ConservationError naming the event, the quantity and the numbers.
    void
    check(const ConservedTotals<dim> &present, const std::string &event, double tolerance);

    /// |present - books| relative to the scale of the quantity.
    Closure
    closure(const ConservedTotals<dim> &present) const;

    /// What energies of the problem are to be measured by: the largest of the kinetic and internal energy introduced,
    /// of what has gone, and of the introduced mass at 1 cm/s, Mbar cm^3.
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
    const std::map<std::string, ConservedTotals<dim>> &
    dropped() const
    {
      return books_.dropped;
    }
    const Conversions &
    conversions() const
    {
      return books_.conversions;
    }
    const std::map<std::string, Event> &
    events() const
    {
      return books_.events;
    }

  private:
    /// What has left or was dropped.
    ConservedTotals<dim>
    gone() const;

    /// present - (introduced - left - dropped), relative to scale.
    Closure
    imbalance(const ConservedTotals<dim> &present) const;

    Books books_;
  };
} // namespace whipple
