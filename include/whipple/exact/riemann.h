// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/exact/exact_factory.h>
#include <whipple/exact/isentrope.h>

namespace whipple::exact
{
  /// Riemann problem of two fluids under any two equations of state: two uniform half spaces meet at time 0. To either
  /// side of the contact runs a shock (Rankine-Hugoniot) or a centred rarefaction (isentrope); the pressure p* and the
  /// velocity u* between them are those at which both sides agree. A function of (x - x0) / t; doc/theory/exact_gas.md.
  ///
  /// For laws whose isentropes and Hugoniots are convex (all of Whipple's in compression).
  class Riemann : public Profile
  {
  public:
    struct State
    {
      std::shared_ptr<const EquationOfState> eos;
      double                                 density  = 0; ///< g/cm^3
      double                                 velocity = 0; ///< cm/us
      double                                 energy   = 0; ///< Mbar cm^3/g
    };

    /// @throws StateError where no such solution exists: the bodies part and leave a vacuum, or a wave is not simple.
    Riemann(const State &left, const State &right, double interface_position = 0.);

    ProfileState
    at(double coordinate, double time) const override;

    /// Edges of fans, shocks and the contact.
    std::vector<double>
    breaks(double time) const override;

    /// The faster shock; none if both waves are fans.
    std::optional<double>
    shock_position(double time) const override;

    double
    pressure() const
    {
      return star_pressure;
    }
    double
    velocity() const
    {
      return star_velocity;
    }

    /// Speeds of the leftmost and rightmost signals, cm/us.
    double
    fastest_left() const
    {
      return -left.head;
    }
    double
    fastest_right() const
    {
      return right.head;
    }

    /// State on the ray (x - x0) / t.
    ProfileState
    on_ray(double ray) const;

    /// Mean density between two rays: from -s rho' + (rho u)' = 0, the integral of rho over s is what rho (s - u)
    /// gains, shocks and contact included.
    double
    mean_density(double low, double high) const;

  private:
    /// What happens to one of the fluids. Speeds are counted outwards, to its own side.
    struct Side
    {
      std::shared_ptr<const EquationOfState> eos;
      FluidPoint                             undisturbed;
      double                                 velocity;  ///< of the undisturbed fluid
      std::unique_ptr<const Isentrope>       isentrope; ///< none if the fluid is cold: it can only be shocked
      FluidPoint                             star;
      bool                                   shocked = false;
      double                                 head = 0, tail = 0; ///< edges of the wave; equal for a shock
    };

    static Side
    make_side(const State &state, double outwards);
    static double
    recoil(const Side &side, double pressure);
    void
    settle(Side &side, double outwards) const;
    void
    find_star();
    ProfileState
    in_side(const Side &side, double ray) const;

    Side   left, right;
    double position;
    double star_pressure = 0, star_velocity = 0;
  };

  ExactKind
  riemann_kind();

  /// From the two bodies of the scene, which touch along axis 1.
  std::unique_ptr<const ExactSolution<2>>
  make_riemann(const ExactRequest<2> &request);
} // namespace whipple::exact
