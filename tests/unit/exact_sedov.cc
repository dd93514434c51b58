// SPDX-License-Identifier: LGPL-2.1-or-later
// Noh [Noh1987] and Sedov (energies of [ExactPack]) against published values and against the equations themselves.
#include "exact_flow_check.h"

#include <whipple/error.h>
#include <whipple/exact/noh.h>
#include <whipple/exact/sedov.h>

namespace
{
  using namespace whipple;
  using exact::Noh;
  using exact::Sedov;

  exact_check::Flow
  gas_flow(int dimensions, double exponent)
  {
    return {dimensions, [exponent](double density, double energy) {
              return exact::FluidPoint{density, energy, (exponent - 1.) * density * energy, 0.};
            }};
  }

  TEST(ExactNoh, PrintedNumbers)
  {
    const double density[] = {4., 16., 64.}, pressure[] = {4. / 3., 16. / 3., 64. / 3.};
    for (int n = 1; n <= 3; ++n)
      {
        const Noh noh({n, 5. / 3., 1., 1.});
        EXPECT_DOUBLE_EQ(*noh.shock_position(0.6), 0.2);
        const exact::ProfileState behind = noh.at(0.1, 0.6);
        EXPECT_NEAR(behind.density, density[n - 1], 1e-12);
        EXPECT_NEAR(behind.pressure, pressure[n - 1], 1e-12);
        EXPECT_EQ(behind.velocity, 0.);
        EXPECT_NEAR(noh.at(0.3, 0.6).density, std::pow(3., n - 1), 1e-12);
      }
  }

  TEST(ExactNoh, SolvesTheEulerEquations)
  {
    for (int n = 1; n <= 3; ++n)
      for (const double exponent : {1.4, 5. / 3., 3.})
        {
          const Noh noh({n, exponent, 1.3, 0.7});
          exact_check::expect_euler(gas_flow(n, exponent), noh, {0.1, 1.}, 0.6);
          exact_check::expect_shock(noh, *noh.shock_position(0.6), 0.6);
        }
  }

  TEST(ExactSedov, PrintedNumbers)
  {
    const double alpha[]  = {0.53874279, 0.98407402, 0.85107185};
    const double radius[] = {1.491374, 1.153787, 1.151666};
    for (int n = 1; n <= 3; ++n)
      {
        EXPECT_NEAR(Sedov({n, 1.4, 1., 1.}).alpha(), alpha[n - 1], 1e-8);
        EXPECT_NEAR(*Sedov({n, 5. / 3., 1., 1.}).shock_position(1.), radius[n - 1], 1e-6);
      }
    const Sedov sphere({3, 1.4, 1., 0.851072});
    EXPECT_NEAR(*sphere.shock_position(1.), 1., 1e-6);
    const exact::ProfileState behind = sphere.at(*sphere.shock_position(1.) - 1e-12, 1.);
    EXPECT_NEAR(behind.density, 6., 1e-8);
    EXPECT_NEAR(behind.pressure, 0.133333, 1e-6);
    EXPECT_NEAR(behind.velocity, 0.333333, 1e-6);
    EXPECT_NEAR(*Sedov({1, 1.4, 1., 0.0673185}).shock_position(1.), 0.5, 1e-4);
    EXPECT_NEAR(*Sedov({2, 1.4, 1., 0.311357}).shock_position(1.), 0.75, 1e-4);
  }

  TEST(ExactSedov, SolvesTheEulerEquations)
  {
    for (int n = 1; n <= 3; ++n)
      for (const double exponent : {1.2, 1.4, 5. / 3., 3.})
        {
          const Sedov  sedov({n, exponent, 1.3, 0.7});
          const double radius = *sedov.shock_position(1.);
          exact_check::expect_euler(gas_flow(n, exponent), sedov, {0.75 * radius, 1.2 * radius}, 1.);
          exact_check::expect_shock(sedov, radius, 1.);
        }
  }

  /// Mass and energy inside the shock are those of the undisturbed gas and of the explosion.
  TEST(ExactSedov, HoldsItsMassAndEnergy)
  {
    const double directions[] = {1., 2. * M_PI, 4. * M_PI};
    for (int n = 1; n <= 3; ++n)
      {
        const Sedov  sedov({n, 1.4, 1.3, 0.7});
        const double radius = *sedov.shock_position(2.);
        double       mass = 0, energy = 0;
        const int    rings = 20000;
        for (int i = 0; i < rings; ++i)
          {
            const double              r      = (i + 0.5) * radius / rings;
            const exact::ProfileState s      = sedov.at(r, 2.);
            const double              volume = directions[n - 1] * std::pow(r, n - 1) * radius / rings;
            mass += s.density * volume;
            energy += (s.pressure / 0.4 + 0.5 * s.density * s.velocity * s.velocity) * volume;
          }
        EXPECT_NEAR(mass, 1.3 * directions[n - 1] / n * std::pow(radius, n), 1e-6 * mass);
        EXPECT_NEAR(energy, 0.7, 1e-6);
      }
  }

  TEST(ExactSedov, RefusesWhatItDoesNotCover)
  {
    EXPECT_THROW(Sedov({3, 2., 1., 1.}), InputError);
    EXPECT_THROW(Sedov({3, 7.5, 1., 1.}), InputError);
  }
} // namespace
