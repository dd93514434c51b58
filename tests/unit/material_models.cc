// SPDX-License-Identifier: LGPL-2.1-or-later
// Strength models without temperature, and the library of materials.
#include "complaint.h"

#include <whipple/error.h>
#include <whipple/material/linear_hardening.h>
#include <whipple/material/material_library.h>
#include <whipple/material/perfectly_plastic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  TEST(Strength, ModelsReturnTheirConstants)
  {
    const std::vector<double> true_density(3, 2.7), e(3, 0.), strain = {0., 0.1, 1.};
    const StrengthInput       state{true_density, e, {}, strain, {}};
    std::vector<double>       shear(3), yield(3);

    const PerfectlyPlastic perfect(0.276, 0.0029);
    perfect.evaluate(state, shear, yield);
    EXPECT_EQ(shear, std::vector<double>(3, 0.276));
    EXPECT_EQ(yield, std::vector<double>(3, 0.0029));

    const LinearHardening hardening({0.25, 3.45e-3, 6.67e-2}); // the 1993 aluminium
    hardening.evaluate(state, shear, yield);
    EXPECT_EQ(shear, std::vector<double>(3, 0.25));
    EXPECT_DOUBLE_EQ(yield[0], 0.00345);
    EXPECT_DOUBLE_EQ(yield[1], 0.01012);
    EXPECT_DOUBLE_EQ(yield[2], 0.07015);
    EXPECT_EQ(hardening.reference_shear_modulus(), 0.25);

    EXPECT_THROW(PerfectlyPlastic(0., 0.003), InputError);
    EXPECT_THROW(PerfectlyPlastic(0.27, -0.003), InputError);
    EXPECT_THROW(LinearHardening({0.27, 0.003, -1.}), InputError);
    EXPECT_THROW(LinearHardening({0.27, std::nan(""), 0.}), InputError);
  }

  TEST(MaterialLibrary, FindsAndListsItsMaterials)
  {
    const MaterialConstants &al = find_material("aluminium 2024-T4");
    EXPECT_DOUBLE_EQ(al.density, 2.785);
    EXPECT_DOUBLE_EQ(al.sound_speed, 0.5328);
    EXPECT_DOUBLE_EQ(al.shear_modulus, 0.286);
    EXPECT_DOUBLE_EQ(al.yield_stress, 0.0026);
    EXPECT_DOUBLE_EQ(al.specific_heat, 8.63e-6);
    EXPECT_NEAR(temperature_rise(al, 0.01), 1158.7, 0.1); // 1 MJ/kg

    const std::string message = complaint_of([] { find_material("unobtainium"); });
    EXPECT_TRUE(contains(message, "unobtainium"));
    for (const std::string &name : material_names())
      EXPECT_TRUE(contains(message, name)) << name;
    EXPECT_GE(material_names().size(), 11u);
    EXPECT_TRUE(std::is_sorted(material_library().begin(), material_library().end(),
                               [](const auto &a, const auto &b) { return a.name < b.name; }));
  }

  TEST(MaterialLibrary, ConstantsArePlausibleAndSourced)
  {
    for (const MaterialConstants &m : material_library())
      {
        SCOPED_TRACE(m.name);
        EXPECT_GT(m.density, 1.);
        EXPECT_LT(m.density, 20.);
        EXPECT_GT(m.sound_speed, 0.19);
        EXPECT_LT(m.sound_speed, 0.9);
        // Poisson's ratio of the bulk and shear moduli.
        const double bulk    = m.density * m.sound_speed * m.sound_speed;
        const double poisson = (3. * bulk - 2. * m.shear_modulus) / (2. * (3. * bulk + m.shear_modulus));
        EXPECT_GT(poisson, 0.);
        EXPECT_LT(poisson, 0.5);
        EXPECT_LT(m.yield_stress, 0.02 * m.shear_modulus);
        // 100 ... 2000 J/(kg K): lead is at one end, beryllium at the other.
        EXPECT_GT(m.specific_heat, 1e-6);
        EXPECT_LT(m.specific_heat, 2e-5);
        EXPECT_FALSE(m.source.empty());
      }
    EXPECT_FALSE(find_material("aluminium 1100-O").caution.empty());
  }
} // namespace whipple
