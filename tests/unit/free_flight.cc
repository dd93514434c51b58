// SPDX-License-Identifier: LGPL-2.1-or-later
// Which fragments fly freely, and that flight is exact.
#include "projection_fixture.h"

#include <whipple/hydro/free_flight.h>
#include <whipple/mesh/cell_geometry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace whipple;
  using namespace whipple::projection_test;

  /// One fragment, 0.025 cm wide, off the axis, half void, at rest.
  struct Fragment
  {
    Lattice<2>  grid;
    FlatMesh<2> mesh;
    State<2>    state;
    Derived     derived;

    explicit Fragment(Symmetry symmetry)
      : grid(lattice(symmetry, 6, 2))
      , mesh(mesh_of(grid, {make_key<2>(2, {{8, 8}})}, Cohesion::fragments))
      , state(blank_state(mesh))
    {
      set_material(state.material[0], 0, state.volume[0], 1.35, 0.002, 0.5);
      state.material[1].void_fraction[0] = 0;
      derived.material.resize(2);
      for (DerivedMaterial &m : derived.material)
        {
          m.pressure      = {0.};
          m.sound_speed   = {0.5};
          m.shear_modulus = {0.28};
          m.yield_stress  = {0.003};
        }
      for (Index n = 0; n < 4; ++n)
        state.node_mass[n] = 1.;
    }

    /// Velocity v = centre + L (x - x of the lower corner).
    void
    set_motion(const Vector<2> &centre, const std::array<Vector<2>, 2> &gradient)
    {
      for (Index n = 0; n < 4; ++n)
        for (int d = 0; d < 2; ++d)
          state.velocity[d][n] = centre[d] + gradient[d][0] * (state.position[0][n] - mesh.lower[0][0]) +
                                 gradient[d][1] * (state.position[1][n] - mesh.lower[1][0]);
    }

    bool
    flies(double dt) const
    {
      return flying_cells(mesh, state, derived, {}, Boundaries<2>{}, dt)[0] != 0;
    }
  };

  TEST(FreeFlight, ExpansionIsExactAtAnyStep)
  {
    for (const Symmetry symmetry : {Symmetry::planar, Symmetry::axisymmetric})
      {
        Fragment fragment(symmetry);
        fragment.set_motion({{0.1, 0.6}}, {{{{0.5, 0.}}, {{0.1, 0.3}}}});
        ASSERT_TRUE(fragment.flies(7.));
        const State<2> before = fragment.state;
        fly(fragment.mesh, 7., fragment.state);
        const MaterialState &m = fragment.state.material[0], &was = before.material[0];
        // the sides grow by 1 + 0.5 * 7 and 1 + 0.3 * 7; the middle moves from r0 + h/2
        double growth = 4.5 * 3.1;
        if (symmetry == Symmetry::axisymmetric)
          {
            const double r = before.position[0][0] + 0.0125;
            growth *= (before.position[0][0] + 0.1 * 7. + 0.0125 * 4.5) / r;
          }
        EXPECT_NEAR(fragment.state.volume[0], growth * before.volume[0], 1e-13 * growth * before.volume[0]);
        EXPECT_NEAR(1. - m.void_fraction[0], 0.5 / growth, 1e-14);
        EXPECT_NEAR(m.density[0] / (1. - m.void_fraction[0]), 2.7, 1e-12);
        EXPECT_NEAR(m.density[0] * m.volume[0], m.mass[0], 1e-14 * m.mass[0]);
        EXPECT_EQ(m.energy[0], was.energy[0]);
        EXPECT_EQ(m.mass[0], was.mass[0]);
      }
  }

  TEST(FreeFlight, WhatWouldCloseFoldOrFeelsStressIsStepped)
  {
    const std::array<Vector<2>, 2> still{};
    Fragment                       fragment(Symmetry::planar);
    fragment.set_motion({{0., 0.6}}, still);
    EXPECT_TRUE(fragment.flies(100.));

    // closes to phi = 0.3 when V = V0 0.5/0.7: at 0.1/us along z after 2.857 us
    fragment.set_motion({{0., 0.6}}, {{{{0., 0.}}, {{0., -0.1}}}});
    EXPECT_TRUE(fragment.flies(2.85));
    EXPECT_FALSE(fragment.flies(2.86));

    // is squeezed across while it grows along: V = V0 (1 - t)(1 + t/2) has its least value at the end only; folds at
    // 0.9
    fragment.set_motion({{0., 0.6}}, {{{{-1., 0.}}, {{0., 0.5}}}});
    EXPECT_TRUE(fragment.flies(0.3));
    EXPECT_FALSE(fragment.flies(0.9));

    // two corners cross each other and part again in between: looked at where it happens, not at the end
    fragment.set_motion({{0., 0.6}}, {{{{-1., 0.}}, {{0., -1.}}}});
    EXPECT_FALSE(fragment.flies(2.5)) << "V = V0 (1 - t)^2 is larger than V0 again";

    fragment.set_motion({{0., 0.6}}, still);
    fragment.derived.material[0].pressure = {2e-4 * 1.35 * 0.25};
    EXPECT_FALSE(fragment.flies(1.));
    fragment.derived.material[0].pressure = {-0.5e-4 * 1.35 * 0.25};
    EXPECT_TRUE(fragment.flies(1.));
    fragment.state.material[0].void_fraction = {0.25};
    EXPECT_FALSE(fragment.flies(1.));
  }

  TEST(FreeFlight, NothingCrossesTheAxis)
  {
    Fragment fragment(Symmetry::axisymmetric);
    fragment.set_motion({{-0.1, 0.6}}, {{{{0.5, 0.}}, {{0., 0.5}}}}); // 0.2 cm off it
    EXPECT_TRUE(fragment.flies(1.5));
    EXPECT_FALSE(fragment.flies(2.5));
  }

  TEST(FreeFlight, RubbleHasNoShear)
  {
    Fragment fragment(Symmetry::planar);
    Derived  derived = fragment.derived;
    soften_rubble(fragment.mesh, fragment.state, 0.6, derived);
    EXPECT_EQ(derived.material[0].shear_modulus[0], 0.28);
    soften_rubble(fragment.mesh, fragment.state, 0.15, derived);
    EXPECT_EQ(derived.material[0].shear_modulus[0], 0.);
    EXPECT_EQ(derived.material[0].yield_stress[0], 0.);
    EXPECT_EQ(derived.material[1].yield_stress[0], 0.003) << "none of it there";

    const FlatMesh<2> bonded = mesh_of(fragment.grid, {make_key<2>(2, {{8, 8}})});
    derived                  = fragment.derived;
    soften_rubble(bonded, fragment.state, 0.15, derived);
    EXPECT_EQ(derived.material[0].shear_modulus[0], 0.28);
  }
} // namespace
