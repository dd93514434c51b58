// SPDX-License-Identifier: LGPL-2.1-or-later
// Guderley's converging and reflected shock against [ExactPack] (exponents, places of the reflected shock) and
// against the equations themselves.
#include "exact_flow_check.h"

#include <whipple/error.h>
#include <whipple/exact/guderley.h>

namespace
{
  using namespace whipple;
  using exact::Guderley;

  struct Printed
  {
    int    dimensions;
    double exponent, alpha, reflection; ///< reflection 0: not printed
  };

  TEST(ExactGuderley, PrintedNumbers)
  {
    for (const Printed &p : {Printed{3, 1.4, 0.717174501, 2.688492680}, Printed{3, 5. / 3., 0.688376823, 1.547894929},
                             Printed{3, 2., 0.667046070, 1.077253818}, Printed{3, 3., 0.636410594, 0.693969704},
                             Printed{3, 6., 0.610339148, 0.}, Printed{2, 1.4, 0.835323192, 2.815610935},
                             Printed{2, 5. / 3., 0.815624901, 1.694792696}, Printed{2, 3., 0.775666619, 0.}})
      {
        const Guderley guderley({p.dimensions, p.exponent, 1., 1.});
        EXPECT_NEAR(guderley.alpha(), p.alpha, 1e-9) << p.dimensions << " " << p.exponent;
        if (p.reflection > 0)
          {
            EXPECT_NEAR(guderley.reflected_shock(), p.reflection, 1e-6) << p.dimensions << " " << p.exponent;
          }
      }
  }

  TEST(ExactGuderley, SolvesTheEulerEquations)
  {
    for (const int dimensions : {2, 3})
      for (const double exponent : {1.4, 5. / 3., 3.})
        {
          const Guderley          guderley({dimensions, exponent, 1.3, 0.8});
          const exact_check::Flow gas{
              dimensions, [exponent](double density, double energy) {
                return exact::FluidPoint{density, energy, (exponent - 1.) * density * energy, 0.};
              }};
          for (const double time : {-0.7, 0.4})
            {
              const double shock = *guderley.shock_position(time);
              exact_check::expect_shock(guderley, shock, time);
              exact_check::expect_euler(gas, guderley, {0.3 * shock, 3. * shock}, time, 2e-6);
            }
          exact_check::expect_euler(gas, guderley, {0.3, 2.}, 0., 2e-6); // the moment of collapse
        }
  }

  TEST(ExactGuderley, RimSpoilsWhatItsSignalReaches)
  {
    const Guderley guderley({3, 1.4, 1., 1., 1.5, -1.});
    EXPECT_TRUE(guderley.counts(1.49, -1.));
    EXPECT_FALSE(guderley.counts(1.51, -1.));
    EXPECT_TRUE(guderley.counts(0.5, -0.8));
    EXPECT_FALSE(guderley.counts(1.4, -0.8));
    EXPECT_FALSE(guderley.counts(0.1, 5.));
  }

  TEST(ExactGuderley, RefusesWhatHasNoSolution)
  {
    EXPECT_THROW(Guderley({3, 1., 1., 1.}), InputError);
  }
} // namespace
