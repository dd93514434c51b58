// SPDX-License-Identifier: LGPL-2.1-or-later
// Strength models, the library of materials, and the factory that turns a request into a material.
#include <whipple/error.h>
#include <whipple/material/linear_hardening.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>
#include <whipple/material/perfectly_plastic.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace whipple
{
  namespace
  {
    /// Message of the InputError that f throws; empty if it throws none.
    std::string
    complaint(const std::function<void()> &f)
    {
      try
        {
          f();
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    std::string
    complaint(const MaterialRequest &request)
    {
      return complaint([&] { make_material(request); });
    }

    bool
    contains(const std::string &text, const std::string &part)
    {
      return text.find(part) != std::string::npos;
    }

    double
    pressure(const EquationOfState &eos, double gamma, double e)
    {
      double p, c2;
      eos.evaluate({&gamma, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
      return p;
    }
  } // namespace

  TEST(Strength, ModelsReturnTheirConstants)
  {
    const std::vector<double> gamma(3, 2.7), e(3, 0.), strain = {0., 0.1, 1.};
    std::vector<double>       shear(3), yield(3);

    const PerfectlyPlastic perfect(0.276, 0.0029);
    perfect.evaluate(gamma, e, strain, shear, yield);
    EXPECT_EQ(shear, std::vector<double>(3, 0.276));
    EXPECT_EQ(yield, std::vector<double>(3, 0.0029));

    const LinearHardening hardening({0.25, 3.45e-3, 6.67e-2}); // the 1993 aluminium
    hardening.evaluate(gamma, e, strain, shear, yield);
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

    const std::string message = complaint([] { find_material("unobtainium"); });
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

  TEST(MaterialFactory, BuildsTheReferenceMaterial)
  {
    MaterialRequest request;
    request.library         = "aluminium 6061-T6";
    request.strength        = "perfectly plastic";
    request.void_law        = "rate";
    request.yield_stress    = 0.00345;
    request.spall_strength  = 0.012;
    const Material material = make_material(request);
    EXPECT_EQ(material.name, "aluminium 6061-T6");
    EXPECT_EQ(material.source, find_material("aluminium 6061-T6").source);
    EXPECT_EQ(material.eos->name(), "mie-grueneisen");
    EXPECT_DOUBLE_EQ(material.eos->reference_density(), 2.703);
    EXPECT_EQ(material.void_law->name(), "rate");
    const double zero = 0., gamma = 2.703;
    double       shear, yield;
    material.strength->evaluate({&gamma, 1}, {&zero, 1}, {&zero, 1}, {&shear, 1}, {&yield, 1});
    EXPECT_DOUBLE_EQ(shear, 0.276);
    EXPECT_DOUBLE_EQ(yield, 0.00345);
  }

  TEST(MaterialFactory, LeavesOutWhatIsNotAskedFor)
  {
    MaterialRequest request;
    request.library         = "copper OFHC";
    const Material material = make_material(request);
    EXPECT_EQ(material.strength, nullptr);
    EXPECT_EQ(material.void_law, nullptr);
    EXPECT_FALSE(material.isothermal);
  }

  TEST(MaterialFactory, EveryListedKindCanBeMade)
  {
    for (const ModelKind &eos : equation_of_state_kinds())
      for (const ModelKind &strength : strength_kinds())
        for (const ModelKind &void_law : void_law_kinds())
          {
            SCOPED_TRACE(eos.name + ", " + strength.name + ", " + void_law.name);
            MaterialRequest request;
            request.library           = "aluminium 1100-O";
            request.equation_of_state = eos.name;
            request.strength          = strength.name;
            request.void_law          = void_law.name;
            if (contains(eos.name, "gas"))
              request.adiabatic_exponent = 1.4;
            if (strength.name == "linear hardening")
              request.hardening_modulus = 0.0667;
            const Material material = make_material(request);
            EXPECT_EQ(material.eos->name(), eos.name);
            EXPECT_EQ(material.strength ? material.strength->name() : "none", strength.name);
            EXPECT_EQ(material.void_law ? material.void_law->name() : "none", void_law.name);
            EXPECT_FALSE(eos.description.empty());
          }
  }

  TEST(MaterialFactory, GasAndPolynomialNeedNoLibrary)
  {
    MaterialRequest gas;
    gas.name               = "air";
    gas.equation_of_state  = "ideal gas";
    gas.density            = 1.;
    gas.adiabatic_exponent = 1.4;
    EXPECT_NEAR(pressure(*make_material(gas).eos, 1., 2.5), 1., 1e-15);

    MaterialRequest polynomial; // 1993
    polynomial.equation_of_state = "linear polynomial";
    polynomial.density           = 2.7;
    polynomial.c1                = 0.652;
    polynomial.isothermal        = true;
    const Material material      = make_material(polynomial);
    EXPECT_TRUE(material.isothermal);
    EXPECT_NEAR(pressure(*material.eos, 2.727, 0.3), 0.00652, 1e-15);
  }

  TEST(MaterialFactory, IsothermalLawsIgnoreTheEnergy)
  {
    MaterialRequest request;
    request.library    = "aluminium 2024-T4";
    const double warm  = pressure(*make_material(request).eos, 2.9, 0.01);
    request.isothermal = true;
    const auto cold    = make_material(request).eos;
    EXPECT_NEAR(warm - pressure(*cold, 2.9, 0.01), 2.0 * 2.785 * 0.01, 1e-14);
    EXPECT_EQ(pressure(*cold, 2.9, 0.01), pressure(*cold, 2.9, 0.));
  }

  TEST(MaterialFactory, SaysWhatIsWrongInOneLine)
  {
    MaterialRequest good;
    good.library  = "aluminium 2024-T4";
    good.strength = "perfectly plastic";
    good.void_law = "rate";
    ASSERT_EQ(complaint(good), "");

    const auto wrong = [&](const std::function<void(MaterialRequest &)> &change) {
      MaterialRequest request = good;
      change(request);
      return complaint(request);
    };
    EXPECT_TRUE(contains(wrong([](auto &r) { r.library = "aluminum"; }), "aluminium 7075-T6"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.equation_of_state = "tillotson"; }), "mie-grueneisen | "));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.strength = "rigid"; }), "none | perfectly plastic | linear hardening"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.void_law = "p-alpha"; }), "none | rate | equilibrium"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.density = -2.7; }), "density = -2.7 g/cm^3: must be > 0"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.yield_stress = -0.1; }), "yield stress = -0.1 Mbar: must be >= 0"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.alpha = -1.; }), "alpha = -1 us/cm^2: must be >= 0"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.spall_strength = -0.01; }), "spall strength = -0.01 Mbar"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.c2 = 0.5; }), "c2 = 0.5: no use to"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.hardening_modulus = 0.1; }), "hardening modulus = 0.1: no use to"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.strength = "linear hardening"; }), "hardening modulus is needed"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.library = ""; }), "no library material is named"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.equation_of_state = "ideal gas"; }), "adiabatic exponent is needed"));
    EXPECT_TRUE(contains(wrong([](auto &r) {
                           r.equation_of_state  = "ideal gas";
                           r.adiabatic_exponent = 1.4;
                           r.isothermal         = true;
                         }),
                         "isothermal"));
  }
} // namespace whipple
