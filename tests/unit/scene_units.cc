// SPDX-License-Identifier: LGPL-2.1-or-later
#include "complaint.h"

#include <whipple/error.h>
#include <whipple/scene/units.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
  using namespace whipple;

  /// The message that a wrong value gets; empty if it is accepted.
  std::string
  complaint(const std::string &text, const units::Quantity &quantity)
  {
    return complaint_of([&] { units::parse(text, quantity); });
  }

  TEST(SceneUnits, AMessageIsOneLineWhateverIsWritten)
  {
    for (const std::string text : {"1 cm\n/s", "1 /\n\ts", "1 \x0e\r\x7f", "\n1"})
      {
        const std::string message = complaint(text, units::velocity);
        EXPECT_FALSE(message.empty());
        for (const char c : message)
          EXPECT_GE(static_cast<unsigned char>(c), 0x20) << message;
      }
  }

  // Decimal units are exact: the result is the double nearest to the decimal value.
  TEST(SceneUnits, DecimalUnitsAreExact)
  {
    EXPECT_EQ(units::parse("6.58 km/s", units::velocity), 0.658);
    EXPECT_EQ(units::parse("6580 m/s", units::velocity), 0.658);
    EXPECT_EQ(units::parse("0.658 cm/us", units::velocity), 0.658);
    EXPECT_EQ(units::parse("0.081 cm", units::length), 0.081);
    EXPECT_EQ(units::parse("0.81 mm", units::length), 0.081);
    EXPECT_EQ(units::parse("810 um", units::length), 0.081);
    EXPECT_EQ(units::parse("8.1e-9 km", units::length), 8.1e-4);
    EXPECT_EQ(units::parse("345 MPa", units::pressure), 0.00345);
    EXPECT_EQ(units::parse("0.345GPa", units::pressure), 0.00345);
    EXPECT_EQ(units::parse("345e6 Pa", units::pressure), 0.00345);
    EXPECT_EQ(units::parse("345e3 kPa", units::pressure), 0.00345);
    EXPECT_EQ(units::parse("3.45e-6 TPa", units::pressure), 3.45e-5);
    EXPECT_EQ(units::parse("3.45 kbar", units::pressure), 0.00345);
    EXPECT_EQ(units::parse("3450 bar", units::pressure), 0.00345);
    EXPECT_EQ(units::parse("0.00345 Mbar", units::pressure), 0.00345);
    EXPECT_EQ(units::parse("0.966e9 dyn/cm^2", units::pressure), 0.966e-3);
    EXPECT_EQ(units::parse("345 N/mm^2", units::pressure), 0.00345);
    EXPECT_EQ(units::parse("2.7 g/cm^3", units::density), 2.7);
    EXPECT_EQ(units::parse("2785 kg/m^3", units::density), 2.785);
    EXPECT_EQ(units::parse("2785 kg m^-3", units::density), 2.785);
    EXPECT_EQ(units::parse("1.5 us", units::time), 1.5);
    EXPECT_EQ(units::parse("1500 ns", units::time), 1.5);
    EXPECT_EQ(units::parse("0.0015 ms", units::time), 1.5);
    EXPECT_EQ(units::parse("1.5e-6 s", units::time), 1.5);
    EXPECT_EQ(units::parse("1e3 us/cm^2", units::void_rate), 1000.);
    EXPECT_EQ(units::parse("1 MJ/kg", units::specific_energy), 0.01);
    EXPECT_EQ(units::parse("1e10 erg/g", units::specific_energy), 0.01);
    EXPECT_EQ(units::parse("0.01 Mbar cm^3/g", units::specific_energy), 0.01);
    EXPECT_EQ(units::parse("0.01 Mbar*cm^3/g", units::specific_energy), 0.01);
    EXPECT_EQ(units::parse("25 kJ", units::energy), 0.25);
    EXPECT_EQ(units::parse("2.5e4 J", units::energy), 0.25);
    EXPECT_EQ(units::parse("2.5e-2 MJ", units::energy), 0.25);
    EXPECT_EQ(units::parse("863 J/(kg K)", units::specific_heat), 863e-8);
    EXPECT_EQ(units::parse("863 J/kg/K", units::specific_heat), 863e-8);
    EXPECT_EQ(units::parse("933.5 K", units::temperature), 933.5);
    EXPECT_EQ(units::parse("99 %", units::number), 0.99);
    EXPECT_EQ(units::parse("+0.5", units::number), 0.5);
    EXPECT_EQ(units::parse("-1.5 cm", units::length), -1.5);
    EXPECT_EQ(units::parse(" 3 mg/mm^3 ", units::density), 3.);
  }

  TEST(SceneUnits, InchesAreExactToRounding)
  {
    EXPECT_DOUBLE_EQ(units::parse("0.032 in", units::length), 0.08128);
  }

  TEST(SceneUnits, MicroMayBeWrittenAsSuch)
  {
    EXPECT_EQ(units::parse("1.5 \u00b5s", units::time), 1.5);
    EXPECT_EQ(units::parse("2 \u03bcm", units::length), units::parse("2 um", units::length));
  }

  TEST(SceneUnits, EverySymbolIsKnown)
  {
    for (const std::string &symbol : units::symbols())
      EXPECT_EQ(complaint("1 " + symbol, units::time).find("unknown unit"), std::string::npos) << symbol;
  }

  TEST(SceneUnits, WrongValuesSayWhatIsAllowed)
  {
    EXPECT_EQ(complaint("0.081", units::length), "the unit is missing; allowed is a length such as 0.081 cm");
    EXPECT_EQ(complaint("0", units::velocity), "the unit is missing; allowed is a velocity such as 6.58 km/s");
    EXPECT_EQ(complaint("345 MPa", units::length),
              "'MPa' is not a unit of length; allowed is a length such as 0.081 cm");
    EXPECT_EQ(complaint("6.58 km", units::velocity),
              "'km' is not a unit of velocity; allowed is a velocity such as 6.58 km/s");
    EXPECT_EQ(complaint("0.5 cm", units::number),
              "'cm' is not a unit of pure number; allowed is a pure number such as 0.5");
    EXPECT_EQ(complaint("fast", units::velocity),
              "not a number with its unit; allowed is a velocity such as 6.58 km/s");
    EXPECT_NE(complaint("345 mpa", units::pressure).find("unknown unit 'mpa' (did you mean 'MPa'?)"),
              std::string::npos);
    EXPECT_NE(complaint("1 furlong", units::length).find("unknown unit 'furlong'; units are km m cm"),
              std::string::npos);
    for (const char *text : {"",
                             "cm",
                             "1 cm^",
                             "1 cm^0",
                             "1 cm^99",
                             "1 /s",
                             "1 cm/",
                             "1 (cm",
                             "1 cm)",
                             "1.2.3 cm",
                             "inf cm",
                             "nan cm",
                             "1e999 cm",
                             "1 cm cm",
                             "1e308 km",
                             "--1 cm",
                             "1,5 cm",
                             "1e99999999999 mm",
                             "1e-99999999999 mm",
                             "1e2147483647 km",
                             "1 (((cm^9)^9)^9)^9",
                             "1 ((((((((((cm))))))))))"})
      EXPECT_NE(complaint(text, units::length), "") << text;
  }

  TEST(SceneUnits, ListsCarryAUnitEach)
  {
    EXPECT_EQ(units::parse_list("0 cm, 1 mm", units::length, 2), (std::vector<double>{0., 0.1}));
    EXPECT_THROW(units::parse_list("0, 1 cm", units::length, 2), InputError);
    EXPECT_THROW(units::parse_list("0 cm", units::length, 2), InputError);
    EXPECT_THROW(units::parse_list("0 cm, 1 cm, 2 cm", units::length, 2), InputError);
    EXPECT_THROW(units::parse_list("0 cm,", units::length, 2), InputError);
  }

  TEST(SceneUnits, FormattedValuesReadBackToTheSameBits)
  {
    std::mt19937                           random(7);
    std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-30, 30);
    for (const units::Quantity &quantity : {units::number, units::length, units::velocity, units::density,
                                            units::pressure, units::specific_energy, units::energy, units::void_rate})
      for (int i = 0; i < 100; ++i)
        {
          const double value = mantissa(random) * std::pow(10., exponent(random));
          EXPECT_EQ(units::parse(units::format(value, quantity), quantity), value);
        }
  }
} // namespace
