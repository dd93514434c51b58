// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/waiting_debris.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace whipple
{
  namespace
  {
    /// What the section of a ring shrinks by as it grows; 1 for one that has come to the axis, which is no ring.
    double
    shrinking(Symmetry symmetry, const Waiting<2> &part, double radial_way)
    {
      const double r = part.centre[0];
      return symmetry == Symmetry::axisymmetric && radial_way != 0 && r > 0 && r + radial_way > 0
                 ? std::sqrt(r / (r + radial_way))
                 : 1.;
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

    /// The voids of an element take up a change of its volume.
    void
    grow(const CellPacketLayout<2> &layout, double growth, Element<2> &element)
    {
      CellPacket &packet = element.packet;
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
      double    mass = 0, volume = 0, area = 0;
      Vector<2> centre{}; ///< of the area
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

  CornerVectors<2>
  corner_velocities_of(const CellPacketLayout<2> &layout, const Waiting<2> &part)
  {
    CornerVectors<2> u;
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 4; ++k)
        u[d][k] = part.element.packet[layout.velocity(d, k)];
    return u;
  }

  CornerVectors<2>
  corners_at(Symmetry symmetry, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time)
  {
    const double           dt = time - part.since;
    const CornerVectors<2> u  = corner_velocities_of(layout, part);
    CornerVectors<2>       x  = part.element.position;
    if (part.element.piece < 0)
      {
        for (int d = 0; d < 2; ++d)
          for (int k = 0; k < 4; ++k)
            x[d][k] += dt * u[d][k];
        return x;
      }
    const double scale = shrinking(symmetry, part, dt * u[0][0]);
    for (int d = 0; d < 2; ++d)
      for (int k = 0; k < 4; ++k)
        x[d][k] = (part.centre[d] + scale * (x[d][k] - part.centre[d])) + dt * u[d][k];
    return x;
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
        }
    std::vector<Element<2>> elements;
    for (const Waiting<2> &part : parts)
      {
        Element<2> element = part.element;
        element.position   = corners_at(symmetry, layout, part, time);
        const double now   = cell_volume<2>(symmetry, element.position);
        if (element.piece >= 0)
          {
            const PieceSum &sum = pieces[element.piece];
            take_share(layout, now / sum.volume * (sum.mass / mass_of(part.element)), element);
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
