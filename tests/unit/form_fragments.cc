// SPDX-License-Identifier: LGPL-2.1-or-later
// Elements gathered into solid pieces: what must stay exact, and what a piece is (doc/theory/fragments.md).
#include "projection_fixture.h"

#include <whipple/mesh/cell_geometry.h>
#include <whipple/projection/form_fragments.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace
{
  using namespace whipple;
  using namespace whipple::projection;
  using namespace whipple::projection_test;

  /// A block of fragments in flight, beside the axis, fully filled with two materials.
  struct Cloud
  {
    Lattice<2>              grid;
    FlatMesh<2>             mesh;
    State<2>                state;
    CellPacketLayout<2>     layout;
    std::vector<Element<2>> elements;

    Cloud(Symmetry symmetry, double scatter)
      : grid(lattice(symmetry, 6, 2))
      , mesh(mesh_of(grid, uniform_keys(grid, 2), Cohesion::fragments))
      , state(blank_state(mesh))
    {
      Random random{17};
      fill_with_both(state, random);
      set_velocities(mesh, state, scatter, random);
      // it has flown outwards and on, and its elements have lost their shape
      for (Index node = 0; node < mesh.n_nodes; ++node)
        {
          state.position[0][node] *= 2.;
          state.position[1][node] = 3. + 1.5 * state.position[1][node];
          for (int d = 0; d < 2; ++d)
            if (d == 1 || state.position[0][node] > 0)
              state.position[d][node] += 0.005 * random(-1., 1.);
        }
      layout   = CellPacketLayout<2>::of(state);
      elements = gather_elements<2>(MPI_COMM_SELF, layout, elements_of<2>(layout, mesh, state));
    }

    LandingView
    view(KineticLoss loss = KineticLoss::heat) const
    {
      return {grid, layout, loss};
    }

    ConservedTotals<2>
    totals(const std::vector<Element<2>> &list) const
    {
      ConservedTotals<2> sum;
      for (const Element<2> &element : list)
        sum += totals_of<2>(layout, element);
      return sum;
    }

    /// First moment of mass along z, of elements that are uniform inside.
    double
    moment(const std::vector<Element<2>> &list) const
    {
      double sum = 0;
      for (const Element<2> &element : list)
        for (int k = 0; k < 4; ++k)
          sum += element.corner_mass[k] * element.position[1][k];
      return sum;
    }
  };

  constexpr double size = 0.15; // six cells

  TEST(FormFragments, MassMomentumAndEnergyAreExactAndPiecesAreSolid)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      for (const KineticLoss loss : {KineticLoss::heat, KineticLoss::drop})
        {
          const Cloud               cloud(symmetry, 0.2);
          FragmentReport            report;
          const std::vector<double> sizes(cloud.elements.size(), size);
          const auto pieces = form_fragments(cloud.view(loss), cloud.elements, sizes, Rings::solid, report);
          ASSERT_EQ(pieces.size(), cloud.elements.size());
          const auto before = cloud.totals(cloud.elements), after = cloud.totals(pieces);
          EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
          EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-13 * before.momentum[1]);
          EXPECT_NEAR(after.momentum[0] + report.axis_impulse, before.momentum[0], 1e-13 * before.momentum[1]);
          EXPECT_GT(report.kinetic_loss, 0.);
          EXPECT_NEAR(after.kinetic_energy + report.kinetic_loss, before.kinetic_energy, 1e-13 * before.kinetic_energy);
          EXPECT_NEAR(after.internal_energy,
                      before.internal_energy + (loss == KineticLoss::heat ? report.kinetic_loss : 0.),
                      1e-13 * before.kinetic_energy);
          EXPECT_NEAR(cloud.moment(pieces), cloud.moment(cloud.elements), 1e-9 * cloud.moment(pieces));
          EXPECT_EQ(report.not_formed, 0);
          EXPECT_NEAR(report.mass, before.mass, 1e-12 * before.mass);

          // Pappus: what the boxes of a piece enclose is what its solid fills
          double solid_before = 0, solid_after = 0;
          for (std::size_t i = 0; i < pieces.size(); ++i)
            {
              double solid = 0;
              for (int m = 0; m < 2; ++m)
                {
                  const CellPacket &was = cloud.elements[i].packet;
                  solid += pieces[i].packet[cloud.layout.volume(m)];
                  solid_before += was[cloud.layout.volume(m)] * (1. - was[cloud.layout.void_fraction(m)]);
                  EXPECT_EQ(pieces[i].packet[cloud.layout.void_fraction(m)], 0.);
                }
              EXPECT_NEAR(cell_volume(symmetry, pieces[i].position), solid, 1e-12 * solid);
              solid_after += solid;
            }
          EXPECT_NEAR(solid_after, solid_before, 1e-13 * solid_before);
        }
  }

  TEST(FormFragments, AThinnedRingKeepsTheSectionThatItsFragmentsHaveAndHoldsVoid)
  {
    const Cloud               cloud(Symmetry::axisymmetric, 0.2);
    FragmentReport            report;
    const std::vector<double> sizes(cloud.elements.size(), size);
    const auto                pieces = form_fragments(cloud.view(), cloud.elements, sizes, Rings::thinned, report);
    const auto                solid  = form_fragments(cloud.view(), cloud.elements, sizes, Rings::solid, report);
    const auto before = cloud.totals(cloud.elements), after = cloud.totals(pieces), dense = cloud.totals(solid);
    EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
    EXPECT_NEAR(after.momentum[1], before.momentum[1], 1e-13 * before.momentum[1]);
    EXPECT_NEAR(after.kinetic_energy, dense.kinetic_energy, 1e-13 * before.kinetic_energy);
    EXPECT_NEAR(cloud.moment(pieces), cloud.moment(cloud.elements), 1e-9 * cloud.moment(pieces));

    struct Ring
    {
      double solid = 0, cells = 0, moment = 0; ///< of the cells it came from: volume of solid, area, area times radius
      double section = 0, filled = 0;          ///< now: area, volume of solid
      bool   on_axis = false;
    };
    std::map<long, Ring> rings;
    const auto           area = [](const Element<2> &e) {
      return (e.position[0][1] - e.position[0][0]) * (e.position[1][2] - e.position[1][0]);
    };
    for (std::size_t i = 0; i < pieces.size(); ++i)
      {
        Ring        &ring = rings[pieces[i].piece];
        const double h    = cloud.grid.extent(key_level(pieces[i].key)) * cloud.grid.spacing;
        const double r    = cloud.grid.origin[0] + cloud.grid.spacing * key_point<2>(pieces[i].key)[0] + 0.5 * h;
        ring.cells += h * h;
        ring.moment += h * h * r;
        ring.section += area(pieces[i]);
        ring.on_axis = ring.on_axis || r < h;
        for (int m = 0; m < 2; ++m)
          {
            const auto full = [&](const CellPacket &p) {
              return p[cloud.layout.volume(m)] * (1. - p[cloud.layout.void_fraction(m)]);
            };
            ring.solid += full(cloud.elements[i].packet);
            ring.filled += full(pieces[i].packet);
          }
      }
    int off_axis = 0;
    for (const auto &[number, ring] : rings)
      {
        EXPECT_NEAR(ring.filled, ring.solid, 1e-12 * ring.solid);
        if (ring.on_axis)
          continue;
        ++off_axis;
        // Pappus, where they came from
        EXPECT_NEAR(2. * std::numbers::pi * ring.moment / ring.cells * ring.section, ring.solid, 1e-11 * ring.solid);
      }
    EXPECT_GT(off_axis, 5);
  }

  TEST(FormFragments, ThePieceOnTheAxisIsOneFragmentAndDoesNotLeaveIt)
  {
    const Cloud               cloud(Symmetry::axisymmetric, 0.2);
    FragmentReport            report;
    const std::vector<double> sizes(cloud.elements.size(), size);
    const auto                pieces   = form_fragments(cloud.view(), cloud.elements, sizes, Rings::solid, report);
    double                    farthest = 0;
    int                       on_axis  = 0;
    for (const Element<2> &piece : pieces)
      {
        EXPECT_GE(piece.position[0][0], 0.);
        if (piece.packet[cloud.layout.velocity(0, 0)] == 0.)
          {
            ++on_axis;
            farthest = std::max(farthest, piece.position[0][1]);
          }
      }
    EXPECT_GT(on_axis, 0);
    EXPECT_LT(farthest, 0.75 * size); // half of a fragment, or a cell more
  }

  TEST(FormFragments, UniformVelocityStaysAndDustIsLeftAlone)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        const Cloud         cloud(symmetry, 0.);
        FragmentReport      report;
        std::vector<double> sizes(cloud.elements.size(), size);
        for (std::size_t i = 0; i < sizes.size(); ++i)
          if (cloud.elements[i].position[1][0] > 3.1)
            sizes[i] = i % 2 ? 0. : 0.03; // has not broken; smaller than two cells
        const auto pieces = form_fragments(cloud.view(), cloud.elements, sizes, Rings::solid, report);
        for (std::size_t i = 0; i < sizes.size(); ++i)
          {
            if (sizes[i] == size)
              for (int k = 0; k < 4; ++k)
                EXPECT_EQ(pieces[i].packet[cloud.layout.velocity(1, k)], 0.6);
            else
              EXPECT_EQ(pieces[i].packet, cloud.elements[i].packet);
          }
        EXPECT_NEAR(report.kinetic_loss, 0., 1e-13);
        EXPECT_GT(report.pieces, 0);
        EXPECT_LT(report.mass, cloud.totals(cloud.elements).mass);
      }
  }
} // namespace
