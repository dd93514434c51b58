// SPDX-License-Identifier: LGPL-2.1-or-later
// The factory that turns a request into a material, and what the models say of themselves.
#include "complaint.h"

#include <whipple/error.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

namespace whipple
{
  namespace
  {
    std::string
    complaint(const MaterialRequest &request)
    {
      return complaint_of([&] { make_material(request); });
    }

    double
    pressure(const EquationOfState &eos, double true_density, double e)
    {
      double p, c2;
      eos.evaluate({&true_density, 1}, {&e, 1}, {&p, 1}, {&c2, 1});
      return p;
    }
  } // namespace

  TEST(MaterialFactory, BuildsTheReferenceMaterial)
  {
    MaterialRequest request;
    request.library                     = "aluminium 6061-T6";
    request.strength                    = "perfectly plastic";
    request.void_law                    = "rate";
    request.constants["Yield stress"]   = 0.00345;
    request.constants["Spall strength"] = 0.012;
    const Material material             = make_material(request);
    EXPECT_EQ(material.name, "aluminium 6061-T6");
    EXPECT_EQ(material.source, find_material("aluminium 6061-T6").source);
    EXPECT_EQ(material.eos->name(), "mie-grueneisen");
    EXPECT_DOUBLE_EQ(material.eos->reference_density(), 2.703);
    EXPECT_EQ(material.void_law->name(), "rate");
    const double zero = 0., true_density = 2.703;
    double       shear, yield;
    material.strength->evaluate({{&true_density, 1}, {&zero, 1}, {}, {&zero, 1}, {}}, {&shear, 1}, {&yield, 1});
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

  TEST(MaterialFactory, EveryModelDescribesItself)
  {
    std::map<std::string, std::string> quantity_of_key;
    for (const ModelFamily &family : model_families())
      {
        EXPECT_FALSE(family.models.empty()) << family.key;
        for (const ModelDescription &model : family.models)
          {
            SCOPED_TRACE(family.key + " " + model.name);
            EXPECT_FALSE(model.summary.empty());
            EXPECT_GT(model.documentation.size(), model.summary.size());
            EXPECT_FALSE(model.source.empty());
            for (const ModelConstant &constant : model.constants)
              {
                // one key means one thing in all models
                const auto [known, is_new] = quantity_of_key.emplace(constant.key, constant.quantity);
                EXPECT_EQ(known->second, constant.quantity) << constant.key;
                EXPECT_FALSE(constant.documentation.empty()) << constant.key;
                if (constant.default_value)
                  {
                    EXPECT_TRUE(constant.range.contains(*constant.default_value)) << constant.key;
                  }
              }
            for (const PublishedConstants &published : model.published)
              for (const auto &[key, value] : published.constants)
                {
                  const auto constant = std::find_if(model.constants.begin(), model.constants.end(),
                                                     [&](const ModelConstant &c) { return c.key == key; });
                  ASSERT_NE(constant, model.constants.end()) << published.material << ": " << key;
                  EXPECT_TRUE(constant->range.contains(value)) << published.material << ": " << key;
                }
          }
      }
  }

  TEST(MaterialFactory, EveryModelCanBeMadeOfWhatIsPublishedForIt)
  {
    int made = 0;
    for (const ModelFamily &family : model_families())
      for (const ModelDescription &model : family.models)
        for (const PublishedConstants &published : model.published)
          {
            SCOPED_TRACE(family.key + " " + model.name + " " + published.material);
            const bool      has_solid = published_constant(model, published.material, "Hugoniot slope").has_value();
            MaterialRequest request;
            request.library        = published.material;
            request.*family.choice = model.name;
            if (family.key != "Equation of state" && !has_solid)
              request.equation_of_state = "tillotson";
            if (family.key == "Strength")
              request.thermal_model = "constant specific heat";
            if (family.key == "Failure" || family.key == "Conduction")
              {
                request.thermal_model = "constant specific heat";
                request.strength      = "perfectly plastic";
                request.void_law      = "rate";
              }
            if (family.key == "Fragments")
              request.void_law = "rate";
            const std::string problem = complaint(request);
            // a source may publish less than a model needs: then the complaint names what is missing
            EXPECT_TRUE(problem.empty() || contains(problem, "is needed by")) << problem;
            made += problem.empty();
          }
    EXPECT_GT(made, 20);
  }

  TEST(MaterialFactory, GasAndPolynomialNeedNoLibrary)
  {
    MaterialRequest gas;
    gas.name                            = "air";
    gas.equation_of_state               = "ideal gas";
    gas.constants["Density"]            = 1.;
    gas.constants["Adiabatic exponent"] = 1.4;
    EXPECT_NEAR(pressure(*make_material(gas).eos, 1., 2.5), 1., 1e-15);

    MaterialRequest polynomial; // 1993
    polynomial.equation_of_state    = "linear polynomial";
    polynomial.constants["Density"] = 2.7;
    polynomial.constants["C1"]      = 0.652;
    polynomial.isothermal           = true;
    const Material material         = make_material(polynomial);
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
    EXPECT_TRUE(contains(wrong([](auto &r) { r.equation_of_state = "tilotson"; }), "mie-grueneisen | "));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.strength = "rigid"; }), "none | "));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.strength = "rigid"; }), "perfectly plastic"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.void_law = "p-beta"; }), "rate"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.constants["Density"] = -2.7; }), "Density = -2.7: must be > 0"));
    EXPECT_TRUE(
        contains(wrong([](auto &r) { r.constants["Yield stress"] = -0.1; }), "Yield stress = -0.1: must be >= 0"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.constants["Alpha"] = -1.; }), "Alpha = -1: must be >= 0 or infinite"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.constants["Spall strength"] = -0.01; }), "Spall strength = -0.01"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.constants["C2"] = 0.5; }), "C2 = 0.5: no use to"));
    EXPECT_TRUE(
        contains(wrong([](auto &r) { r.constants["Hardening modulus"] = 0.1; }), "Hardening modulus = 0.1: no use to"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.strength = "linear hardening"; }), "Hardening modulus is needed"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.library = ""; }), "no library material is named"));
    EXPECT_TRUE(contains(wrong([](auto &r) { r.equation_of_state = "ideal gas"; }), "Adiabatic exponent is needed"));
    EXPECT_TRUE(contains(wrong([](auto &r) {
                           r.equation_of_state               = "ideal gas";
                           r.constants["Adiabatic exponent"] = 1.4;
                           r.isothermal                      = true;
                         }),
                         "isothermal"));
  }

  TEST(MaterialFactory, ModelsThatContradictEachOtherAreRejected)
  {
    MaterialRequest request;
    request.library    = "aluminium 2024-T4";
    request.conduction = "constant conductivity";
    EXPECT_TRUE(contains(complaint(request), "needs a thermal model"));
    request.thermal_model = "constant specific heat";
    EXPECT_EQ(complaint(request), "");
    request.isothermal = true;
    EXPECT_TRUE(contains(complaint(request), "isothermal = true with heat conduction"));
  }
} // namespace whipple
