// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/waiting_debris.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace whipple
{
  namespace
  {
    /// Where a piece is: the middle of its section has moved by `way` from its axis, and the section has shrunk.
    struct Flight
    {
      double way   = 0;     ///< along axis 0, cm
      double scale = 1;     ///< of lengths
      bool   back  = false; ///< it has been at the axis and flies outwards
    };

    /// A ring shrinks in section as it grows, until it is as large as where void opens in it. Its fragments fly past
    /// each other at the axis: it turns where it touches it.
    Flight
    flight_of(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double dt)
    {
      const double r = part.centre[0], way = dt * part.element.packet[layout.velocity(0, 0)];
      if (symmetry == Symmetry::planar || way == 0 || !(r > 0))
        return {way, 1., false};
      const double within = part.element.solid_within, solid = std::min(r, within);
      double       nearest = std::cbrt(solid * part.reach * part.reach); // the ring touches the axis: r = scale reach
      if (nearest > within)
        nearest = std::sqrt(solid / within) * part.reach;
      nearest           = std::min(nearest, r); // it touched it from the beginning
      const bool   back = r + way < nearest;
      const double now  = back ? 2. * nearest - (r + way) : r + way;
      return {back ? now - r : way, std::sqrt(solid / std::min(now, within)), back};
    }

    /// An element for itself that has flown across the axis, on the side where it counts.
    void
    mirror(CornerVectors<2> &x, CornerVectors<2> &u)
    {
      for (int k = 0; k < 4; ++k)
        {
          x[0][k] = -x[0][k];
          u[0][k] = -u[0][k];
        }
      for (CornerVectors<2> *v : {&x, &u})
        for (int d = 0; d < 2; ++d)
          for (const int lower : {0, 2})
            std::swap((*v)[d][lower], (*v)[d][lower + 1]);
    }

    double
    volume_at(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time)
    {
      return cell_volume<2>(symmetry, corners_at(symmetry, layout, part, time));
    }

    /// Scale what an element holds of everything.
    void
    take_share(const CellPacketLayout<2> &layout, double share, Element<2> &element)
    {
      for (double &mass : element.corner_mass)
        mass *= share;
      element.packet[layout.kinetic_remainder()] *= share;
      for (int m = 0; m < layout.n_materials(); ++m)
        {
          element.packet[layout.mass(m)] *= share;
          element.packet[layout.volume(m)] *= share;
        }
    }

    /// The voids of an element take up a change of its volume; of what has none left nothing is pressed.
    void
    grow(const CellPacketLayout<2> &layout, double growth, Element<2> &element)
    {
      CellPacket &packet = element.packet;
      for (int m = 0; m < layout.n_materials(); ++m)
        if (packet[layout.volume(m)] > 0)
          growth = std::max(growth, 1. - packet[layout.void_fraction(m)]);
      for (int m = 0; m < layout.n_materials(); ++m)
        if (packet[layout.volume(m)] > 0)
          {
            packet[layout.volume(m)] *= growth;
            packet[layout.density(m)] /= growth;
            packet[layout.void_fraction(m)] = 1. - (1. - packet[layout.void_fraction(m)]) / growth;
          }
    }

    /// Sums over the parts of each piece.
    struct PieceSum
    {
      double    mass = 0, volume = 0, volume_then = 0, area = 0;
      double    least = std::numeric_limits<double>::infinity(); ///< radius
      Vector<2> centre{};                                        ///< of the area
    };

    double
    mass_of(const Element<2> &element)
    {
      double mass = 0;
      for (const double corner : element.corner_mass)
        mass += corner;
      return mass;
    }
  } // namespace

  std::vector<Waiting<2>>
  begin_to_wait(const CellPacketLayout<2> &layout, std::vector<Waiting<2>> waiting, std::vector<Element<2>> elements,
                std::span<const int> stress, double time)
  {
    long first = 0;
    for (const Waiting<2> &part : waiting)
      first = std::max(first, part.element.piece + 1);
    std::map<long, PieceSum> pieces;
    for (const Element<2> &element : elements)
      if (element.piece >= 0)
        {
          PieceSum       &sum  = pieces[element.piece];
          const double    own  = CellShape<2>::area(element.position);
          const Vector<2> here = CellShape<2>::middle(element.position);
          sum.area += own;
          sum.least = std::min(sum.least, *std::min_element(element.position[0].begin(), element.position[0].end()));
          for (int d = 0; d < 2; ++d)
            sum.centre[d] += (here[d] - sum.centre[d]) * (own / sum.area);
        }
    std::stable_sort(elements.begin(), elements.end(), [](const auto &a, const auto &b) { return a.piece < b.piece; });
    for (Element<2> &element : elements)
      {
        Waiting<2> part{std::move(element), time, {}};
        if (part.element.piece >= 0)
          {
            part.centre = pieces[part.element.piece].centre;
            part.reach  = part.centre[0] - pieces[part.element.piece].least;
            part.element.piece += first;
          }
        else
          {
            part.centre = CellShape<2>::middle(part.element.position);
            for (int m = 0; m < layout.n_materials(); ++m)
              for (const int field : stress)
                part.element.packet[layout.field(m, field)] = 0.;
          }
        waiting.push_back(std::move(part));
      }
    return waiting;
  }

  std::pair<CornerVectors<2>, CornerVectors<2>>
  motion_at(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time)
  {
    const double     dt = time - part.since;
    CornerVectors<2> x  = part.element.position, u;
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 4; ++k)
        u[d][k] = part.element.packet[layout.velocity(d, k)];
    if (part.element.piece < 0)
      {
        for (int d = 0; d < 2; ++d)
          for (int k = 0; k < 4; ++k)
            x[d][k] += dt * u[d][k];
        if (symmetry == Symmetry::axisymmetric && CellShape<2>::middle(x)[0] < 0)
          mirror(x, u);
        return {x, u};
      }
    const Flight    flight = flight_of(symmetry, layout, part, dt);
    const Vector<2> way{{flight.way, dt * u[1][0]}};
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 4; ++k)
        x[d][k] = (part.centre[d] + flight.scale * (x[d][k] - part.centre[d])) + way[d];
    if (flight.back)
      for (double &radial : u[0])
        radial = -radial;
    return {x, u};
  }

  CornerVectors<2>
  corners_at(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time)
  {
    return motion_at(symmetry, layout, part, time).first;
  }

  std::vector<Element<2>>
  elements_at(Symmetry symmetry, const CellPacketLayout<2> &layout, std::span<const Waiting<2>> parts, double time)
  {
    std::map<long, PieceSum> pieces;
    for (const Waiting<2> &part : parts)
      if (part.element.piece >= 0)
        {
          PieceSum &sum = pieces[part.element.piece];
          sum.mass += mass_of(part.element);
          sum.volume += volume_at(symmetry, layout, part, time);
          sum.volume_then += cell_volume<2>(symmetry, part.element.position);
        }
    std::vector<Element<2>> elements;
    for (const Waiting<2> &part : parts)
      {
        Element<2> element = part.element;
        const auto [x, u]  = motion_at(symmetry, layout, part, time);
        element.position   = x;
        for (int d = 0; d < 2; ++d)
          for (int k = 0; k < 4; ++k)
            element.packet[layout.velocity(d, k)] = u[d][k];
        const double now = cell_volume<2>(symmetry, x);
        if (element.piece >= 0)
          {
            const PieceSum &sum = pieces[element.piece];
            take_share(layout, now / sum.volume * (sum.mass / mass_of(part.element)), element);
            if (std::isfinite(element.solid_within))
              grow(layout, sum.volume / sum.volume_then, element);
          }
        else
          grow(layout, now / cell_volume<2>(symmetry, part.element.position), element);
        elements.push_back(std::move(element));
      }
    return elements;
  }

  double
  void_fraction_at(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time)
  {
    return 1. - solid_volume(layout, part.element.packet) / volume_at(symmetry, layout, part, time);
  }
} // namespace whipple
