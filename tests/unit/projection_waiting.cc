// SPDX-License-Identifier: LGPL-2.1-or-later
// Debris that waits outside the mesh flies straight, keeps what it holds, and a ring of it keeps its solid.
#include "../flying_element.h"

#include <whipple/projection/waiting_debris.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace
{
  using namespace whipple;

  /// One material with voids and one carried field.
  CellPacketLayout<2>
  one_material()
  {
    CellPacketLayout<2> layout;
    layout.has_voids = {true};
    layout.carrier   = {Carrier::volume};
    return layout;
  }

  /// A rectangle [r, r + dr] x [z, z + dz] of density 2.7 (1 - phi), its corners moving with u + rate (x - x of corner
  /// 0).
  Element<2>
  rectangle(Symmetry symmetry, double r, double z, double dr, double dz, double phi, const Vector<2> &u, double rate)
  {
    const CellPacketLayout<2> layout  = one_material();
    Element<2>                element = flying_rectangle(layout, symmetry, {{r, z}}, {{dr, dz}}, 2.7, 0.003, phi, u);
    for (int k = 0; k < 4; ++k)
      {
        element.packet[layout.velocity(0, k)] += rate * (element.position[0][k] - r);
        element.packet[layout.velocity(1, k)] += rate * (element.position[1][k] - z);
      }
    element.packet[layout.field(0, 0)] = 1e-3;
    return element;
  }

  /// A ring of solid in two parts that meet at the radius `middle`, each 0.1 cm wide.
  std::vector<Element<2>>
  ring_of_two_parts(double middle, double dz, const Vector<2> &u, double solid_within)
  {
    std::vector<Element<2>> parts;
    for (const double r : {middle - 0.1, middle})
      {
        parts.push_back(rectangle(Symmetry::axisymmetric, r, 0., 0.1, dz, 0., u, 0.));
        parts.back().piece        = 0;
        parts.back().solid_within = solid_within;
      }
    return parts;
  }

  ConservedTotals<2>
  sum_of(const std::vector<Element<2>> &elements)
  {
    ConservedTotals<2> sum;
    for (const Element<2> &element : elements)
      sum += totals_of(one_material(), element);
    return sum;
  }

  /// Planar: a square of edge a whose corners part with the rate D is a square of edge a (1 + D t) after t, and its
  /// solid is what it was.
  TEST(WaitingDebris, AnElementFliesStraightAndItsVoidsTakeUpItsVolume)
  {
    const CellPacketLayout<2> layout  = one_material();
    const Element<2>          element = rectangle(Symmetry::planar, 1., 2., 0.1, 0.1, 0.5, {{0.1, 0.6}}, 0.25);
    const std::array<int, 1>  stress{0};
    const auto                parts = begin_to_wait(layout, {}, {element}, stress, 3.);
    const auto                later = elements_at(Symmetry::planar, layout, parts, 7.);
    ASSERT_EQ(later.size(), 1u);
    const double factor = 1. + 0.25 * 4.;
    EXPECT_NEAR(later[0].position[0][0], 1.4, 1e-14);
    EXPECT_NEAR(later[0].position[1][0], 4.4, 1e-14);
    EXPECT_NEAR(later[0].position[0][3], 1.4 + 0.1 * factor, 1e-14);
    EXPECT_NEAR(later[0].position[1][3], 4.4 + 0.1 * factor, 1e-14);
    EXPECT_NEAR(later[0].packet[layout.volume(0)], 0.01 * factor * factor, 1e-15);
    EXPECT_NEAR(later[0].packet[layout.void_fraction(0)], 1. - 0.5 / (factor * factor), 1e-14);
    EXPECT_NEAR(later[0].packet[layout.density(0)], 2.7 * 0.5 / (factor * factor), 1e-14);
    EXPECT_EQ(later[0].packet[layout.field(0, 0)], 0.); // stress
    EXPECT_EQ(later[0].packet[layout.mass(0)], element.packet[layout.mass(0)]);
    EXPECT_NEAR(void_fraction_at(Symmetry::planar, layout, parts[0], 7.), later[0].packet[layout.void_fraction(0)],
                1e-14);
    // in one leap or in two: the same bits, as places count from the beginning
    EXPECT_EQ(elements_at(Symmetry::planar, layout, parts, 3.)[0].position, element.position);
  }

  /// A ring of solid of two parts flies outwards: Pappus' volume 2 pi R A stays, so the section shrinks as 1/R, and
  /// what it holds is divided anew between its parts.
  TEST(WaitingDebris, ARingKeepsItsSolid)
  {
    const CellPacketLayout<2> layout = one_material();
    const Vector<2>           u{{0.2, 0.5}};
    const auto                elements = ring_of_two_parts(0.6, 0.1, u, std::numeric_limits<double>::infinity());
    const auto                parts    = begin_to_wait(layout, {}, elements, {}, 0.);
    const auto                later    = elements_at(Symmetry::axisymmetric, layout, parts, 3.);
    const double              middle = 0.6 + 0.2 * 3., scale = std::sqrt(0.6 / middle);
    EXPECT_NEAR(later[0].position[0][1], middle, 1e-14); // where the parts meet
    EXPECT_NEAR(later[1].position[0][0], middle, 1e-14);
    EXPECT_NEAR(later[1].position[0][1], middle + scale * 0.1, 1e-14);
    EXPECT_NEAR(later[0].position[1][2] - later[0].position[1][0], scale * 0.1, 1e-14);
    double volume = 0;
    for (const Element<2> &element : later)
      {
        const double own = cell_volume<2>(Symmetry::axisymmetric, element.position);
        volume += own;
        EXPECT_NEAR(element.packet[layout.mass(0)], 2.7 * own, 1e-14);
        EXPECT_NEAR(element.packet[layout.volume(0)], own, 1e-14);
        EXPECT_EQ(element.packet[layout.density(0)], 2.7);
        EXPECT_EQ(element.packet[layout.void_fraction(0)], 0.);
        EXPECT_EQ(element.packet[layout.field(0, 0)], 1e-3); // a piece is not touched
      }
    EXPECT_NEAR(volume, 2. * std::numbers::pi * 0.6 * 0.02, 1e-14);
    const auto before = sum_of(elements), after = sum_of(later);
    EXPECT_NEAR(after.mass, before.mass, 1e-15);
    EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-15);
    EXPECT_NEAR(after.total_energy(), before.total_energy(), 1e-15);
  }

  /// A ring that is solid within 0.6 cm keeps the section it has there, and void opens in it: at twice the radius half.
  TEST(WaitingDebris, ARingOfFragmentsThinsOut)
  {
    const CellPacketLayout<2> layout = one_material();
    const Vector<2>           u{{0.2, 0.5}};
    const auto                elements = ring_of_two_parts(0.5, 0.2, u, 0.6);
    const auto                parts    = begin_to_wait(layout, {}, elements, {}, 0.);
    for (const double time : {0.5, 3.5}) // the middle of 0.5 cm has come to 0.6, and to 1.2 cm
      {
        const double middle = 0.5 + 0.2 * time, void_fraction = 1. - std::min(1., 0.6 / middle);
        double       section = 0, solid = 0, mass = 0;
        for (const Element<2> &element : elements_at(Symmetry::axisymmetric, layout, parts, time))
          {
            section += CellShape<2>::area(element.position);
            solid += element.packet[layout.volume(0)] * (1. - element.packet[layout.void_fraction(0)]);
            mass += element.packet[layout.mass(0)];
            EXPECT_NEAR(element.packet[layout.void_fraction(0)], void_fraction, 1e-13);
            EXPECT_NEAR(element.packet[layout.density(0)], 2.7 * (1. - void_fraction), 1e-13);
            EXPECT_NEAR(cell_volume<2>(Symmetry::axisymmetric, element.position), element.packet[layout.volume(0)],
                        1e-13);
          }
        EXPECT_NEAR(section, 0.04 * 0.5 / 0.6, 1e-14) << time;
        EXPECT_NEAR(solid, 2. * std::numbers::pi * 0.5 * 0.04, 1e-13);
        EXPECT_NEAR(mass, 2.7 * solid, 1e-13);
      }
  }

  /// Fragments of a ring that fly towards the axis pass it: the ring turns where it touches it, and is as before on its
  /// way out.
  TEST(WaitingDebris, ARingTurnsAtTheAxis)
  {
    const CellPacketLayout<2> layout = one_material();
    for (const double within : {0.3, 0.7, 2.})
      {
        const Vector<2> u{{-0.25, 0.5}};
        Element<2>      element = rectangle(Symmetry::axisymmetric, 0.9, 0., 0.2, 0.2, 0., u, 0.);
        element.piece           = 0;
        element.solid_within    = within;
        if (within < 1.) // it is farther out, and holds void
          {
            element.packet[layout.void_fraction(0)] = 1. - within;
            element.packet[layout.mass(0)] *= within;
            element.packet[layout.density(0)] *= within;
            for (double &mass : element.corner_mass)
              mass *= within;
          }
        const auto parts   = begin_to_wait(layout, {}, {element}, {}, 0.);
        double     nearest = 1.;
        for (double time = 0; time < 9.; time += 0.01)
          {
            const auto x = corners_at(Symmetry::axisymmetric, layout, parts[0], time);
            EXPECT_GE(x[0][0], -1e-15) << time;
            nearest              = std::min(nearest, x[0][0]);
            const Element<2> now = elements_at(Symmetry::axisymmetric, layout, parts, time)[0];
            EXPECT_NEAR(now.packet[layout.mass(0)], element.packet[layout.mass(0)], 1e-13);
            EXPECT_NEAR(now.packet[layout.density(0)] / (1. - now.packet[layout.void_fraction(0)]), 2.7, 1e-12);
            EXPECT_NEAR(now.packet[layout.volume(0)], cell_volume<2>(Symmetry::axisymmetric, now.position), 1e-12);
          }
        EXPECT_LT(nearest, 0.0025);
        EXPECT_EQ(motion_at(Symmetry::axisymmetric, layout, parts[0], 1.).second[0][2], -0.25);
        EXPECT_EQ(motion_at(Symmetry::axisymmetric, layout, parts[0], 9.).second[0][2], 0.25);
      }
  }

  /// An element for itself that has flown across the axis is its mirror image, not turned over.
  TEST(WaitingDebris, AnElementBeyondTheAxisIsItsMirrorImage)
  {
    const CellPacketLayout<2> layout  = one_material();
    const Element<2>          element = rectangle(Symmetry::axisymmetric, 0.3, 0., 0.1, 0.1, 0.5, {{-0.2, 0.6}}, 0.);
    const auto                parts   = begin_to_wait(layout, {}, {element}, {}, 0.);
    const Element<2> after  = elements_at(Symmetry::axisymmetric, layout, parts, 3.5)[0]; // 0.3..0.4 -> -0.4..-0.3
    const Element<2> before = elements_at(Symmetry::axisymmetric, layout, parts, 0.)[0];
    for (int k = 0; k < 4; ++k)
      {
        EXPECT_NEAR(after.position[0][k], before.position[0][k], 1e-14);
        EXPECT_EQ(after.packet[layout.velocity(0, k)], 0.2);
      }
    EXPECT_NEAR(after.packet[layout.density(0)], before.packet[layout.density(0)], 1e-13);
  }

  TEST(WaitingDebris, PiecesOfTwoHandOversKeepApart)
  {
    const CellPacketLayout<2> layout = one_material();
    Element<2>                piece  = rectangle(Symmetry::planar, 0., 0., 0.1, 0.1, 0., {{0., 0.5}}, 0.);
    piece.piece                      = 0;
    auto parts                       = begin_to_wait(layout, {}, {piece}, {}, 0.);
    parts                            = begin_to_wait(layout, parts, {piece}, {}, 1.);
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_NE(parts[0].element.piece, parts[1].element.piece);
    EXPECT_EQ(parts[0].since, 0.);
    EXPECT_EQ(parts[1].since, 1.);
  }
} // namespace
