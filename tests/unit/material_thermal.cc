// SPDX-License-Identifier: LGPL-2.1-or-later
// Temperature, melting and boiling beside an equation of state. Figures in comments "independent" come from a separate
// integration (adaptive 8th order, tolerance 1e-12) of the equations of doc/theory/melting.md.
#include <whipple/error.h>
#include <whipple/material/constant_specific_heat.h>
#include <whipple/material/equation_of_state_temperature.h>
#include <whipple/material/ideal_gas.h>
#include <whipple/material/linear_polynomial.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>
#include <whipple/material/mie_grueneisen.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace whipple
{
  namespace
  {
    constexpr double reference_density = 2.703, cv = 8.85e-6, gruneisen = 1.97; // aluminium 6061-T6

    const MieGrueneisen &
    aluminium()
    {
      static const MieGrueneisen eos({reference_density, 0.524, 1.40, gruneisen});
      return eos;
    }

    ConstantSpecificHeat::Constants
    solid_only()
    {
      ConstantSpecificHeat::Constants constants;
      constants.specific_heat = cv;
      return constants;
    }

    ConstantSpecificHeat::Constants
    with_phases()
    {
      ConstantSpecificHeat::Constants constants = solid_only();
      constants.melting_point                   = 933.5;
      constants.heat_of_fusion                  = 0.00398;
      constants.grueneisen                      = gruneisen;
      constants.volume_correction               = 1.5;
      constants.boiling_point                   = 2792.;
      constants.heat_of_vaporisation            = 0.109;
      return constants;
    }

    struct State
    {
      double temperature, melt_temperature, melt_fraction, vapour_fraction;
    };

    State
    at(const ThermalModel &thermal, double density, double energy)
    {
      State s{};
      thermal.evaluate({&density, 1}, {&energy, 1},
                       {{&s.temperature, 1}, {&s.melt_temperature, 1}, {&s.melt_fraction, 1}, {&s.vapour_fraction, 1}});
      return s;
    }

    double
    pressure(const EquationOfState &eos, double density, double energy)
    {
      double p, square;
      eos.evaluate({&density, 1}, {&energy, 1}, {&p, 1}, {&square, 1});
      return p;
    }

    /// Density below gamma0 of zero pressure.
    double
    released(const EquationOfState &eos, double energy)
    {
      double low = 0.15 * eos.reference_density(), high = eos.reference_density();
      for (int i = 0; i < 100; ++i)
        {
          const double middle                               = 0.5 * (low + high);
          (pressure(eos, middle, energy) > 0. ? high : low) = middle;
        }
      return high;
    }

    std::string
    complaint(const MaterialRequest &request)
    {
      try
        {
          make_material(request);
        }
      catch (const InputError &error)
        {
          return error.what();
        }
      return "";
    }

    /// An equation of state that knows its temperature: an ideal gas.
    class KnowingGas : public IdealGas, public ThermalModel
    {
    public:
      KnowingGas()
        : IdealGas(1.4, 1.)
      {
      }
      using IdealGas::evaluate;
      void
      evaluate(std::span<const double>, std::span<const double> energy, const ThermalOutput &output) const override
      {
        for (std::size_t i = 0; i < output.temperature.size(); ++i)
          output.temperature[i] = energy[i] / 1e-5;
      }
      double
      specific_heat() const override
      {
        return 1e-5;
      }
      Transitions
      transitions() const override
      {
        return {};
      }
      std::string
      name() const override
      {
        return "knowing gas";
      }
    };
  } // namespace

  TEST(CubicTable, ReproducesCubicsAndKeepsItsEnds)
  {
    const auto                    f     = [](double x) { return 1. - 2. * x + 3. * x * x - 0.5 * x * x * x; };
    const auto                    slope = [](double x) { return -2. + 6. * x - 1.5 * x * x; };
    std::vector<CubicTable::Node> nodes;
    for (int i = 0; i <= 4; ++i)
      nodes.push_back({f(0.5 * i), slope(0.5 * i)});
    const CubicTable table(0., 2., nodes);
    for (double x = 0.; x <= 2.; x += 0.037)
      EXPECT_NEAR(table(x), f(x), 1e-14);
    EXPECT_EQ(table(-1.), f(0.));
    EXPECT_DOUBLE_EQ(table(3.), f(2.));
    EXPECT_DOUBLE_EQ(table(2.), f(2.));
    EXPECT_THROW(CubicTable(0., 1., {{1., 0.}}), std::logic_error);
  }

  TEST(ThermalModel, MatchesIndependentIntegrationOfTheIsentrope)
  {
    const ConstantSpecificHeat thermal(aluminium(), solid_only());
    EXPECT_EQ(at(thermal, reference_density, 0.).temperature, 300.);
    EXPECT_NEAR(at(thermal, reference_density, cv * 100.).temperature, 400., 1e-10);
    const double independent[][3] = {{0.7, 0.05, 3516.2587182022403},
                                     {0.9, 0.004, 628.8271081978496},
                                     {1.04, 0.003, 592.6811011850764},
                                     {1.3, 0.03, 2559.4999550801535},
                                     {2.5, 0.15, 4829.425407430333}};
    for (const auto &[v, energy, temperature] : independent)
      EXPECT_NEAR(at(thermal, reference_density / v, energy).temperature, temperature, 1e-6 * temperature) << v;
    EXPECT_EQ(at(thermal, 2.5, 0.02).melt_fraction, 0.);
    EXPECT_TRUE(std::isinf(at(thermal, 2.5, 0.02).melt_temperature));
    EXPECT_TRUE(std::isinf(thermal.transitions().melt_onset));
  }

  TEST(ThermalModel, HeatsByGammaAlongEveryIsentrope)
  {
    // d ln T / d ln gamma = Gamma = Gamma0 gamma0 / gamma at constant entropy, de = P / gamma^2 dgamma: what makes
    // temperature and pressure come from one free energy.
    const ConstantSpecificHeat thermal(aluminium(), solid_only());
    for (const double density : {1.2, 2.0, 2.6, 2.8, 3.5, 4.5})
      for (const double temperature : {400., 3000., 10000.})
        {
          const double energy = cv * (temperature - at(thermal, density, 0.).temperature);
          const double h      = 1e-5 * density;
          const auto   moved  = [&](double step) { // second order along the isentrope
            const double half = energy + 0.5 * step * pressure(aluminium(), density, energy) / (density * density);
            const double mid  = density + 0.5 * step;
            return energy + step * pressure(aluminium(), mid, half) / (mid * mid);
          };
          const double rise = std::log(at(thermal, density + h, moved(h)).temperature /
                                       at(thermal, density - h, moved(-h)).temperature);
          EXPECT_NEAR(rise / std::log((density + h) / (density - h)), gruneisen * reference_density / density, 1e-4)
              << density << " " << temperature;
        }
  }

  TEST(ThermalModel, GasAndColdCurveAreExact)
  {
    ConstantSpecificHeat::Constants gas;
    gas.specific_heat         = 7.18e-6;
    gas.reference_temperature = 0.;
    const IdealGas air(1.4, 1.);
    for (const double density : {0.2, 1., 3.})
      EXPECT_DOUBLE_EQ(at(ConstantSpecificHeat(air, gas), density, 0.01).temperature, 0.01 / 7.18e-6);

    // P = K mu without energy: e_T = (K / gamma0) (ln eta + 1/eta - 1), by hand.
    LinearPolynomial::Constants cold;
    cold.reference_density = 2.7;
    cold.c1                = 0.652;
    const LinearPolynomial     law(cold);
    const ConstantSpecificHeat thermal(law, solid_only());
    for (const double eta : {0.8, 1.1, 1.6})
      {
        const double isotherm = 0.652 / 2.7 * (std::log(eta) + 1. / eta - 1.);
        EXPECT_NEAR(at(thermal, 2.7 * eta, 0.03).temperature, 300. + (0.03 - isotherm) / cv, 1e-5);
      }
  }

  TEST(ThermalModel, MeltsAtItsMeltingPointWithoutPressure)
  {
    const ConstantSpecificHeat thermal(aluminium(), with_phases());
    const auto                 t = thermal.transitions();
    EXPECT_NEAR(t.melt_onset, 0.006105671428, 1e-9); // independent
    EXPECT_DOUBLE_EQ(t.melt_complete, t.melt_onset + 0.00398);
    const double solid = released(aluminium(), t.melt_onset), liquid = released(aluminium(), t.melt_complete);
    EXPECT_NEAR(reference_density / solid, 1.0457176995, 1e-7); // independent
    EXPECT_NEAR(at(thermal, solid, t.melt_onset).temperature, 933.5, 1e-4);
    EXPECT_NEAR(at(thermal, solid, t.melt_onset).melt_fraction, 0., 1e-6);
    EXPECT_NEAR(at(thermal, liquid, t.melt_complete).temperature, 933.5, 1e-4);
    EXPECT_NEAR(at(thermal, liquid, t.melt_complete).melt_fraction, 1., 1e-6);
    double last = 0.;
    for (int i = 1; i < 20; ++i)
      {
        const double energy = t.melt_onset + 0.00398 * i / 20.;
        const State  s      = at(thermal, released(aluminium(), energy), energy);
        EXPECT_DOUBLE_EQ(s.temperature, s.melt_temperature);
        EXPECT_GT(s.melt_fraction, last);
        last = s.melt_fraction;
      }
    EXPECT_LT(last, 1.);
  }

  TEST(ThermalModel, MeltFractionGrowsLinearlyAndTemperatureWaits)
  {
    const ConstantSpecificHeat thermal(aluminium(), with_phases());
    const ConstantSpecificHeat frozen(aluminium(), solid_only());
    const double               independent[][2] = {{1.0, 1083.8914112}, {0.9, 1505.8481056}, {0.7, 2938.9397151}};
    constexpr double           fusion           = 0.00335481670502; // at constant density, independent
    for (const auto &[v, melt] : independent)
      {
        const double density = reference_density / v;
        const double onset   = cv * (melt - at(frozen, density, 0.).temperature);
        for (const double share : {0.001, 0.3, 0.999})
          {
            const State s = at(thermal, density, onset + share * fusion);
            EXPECT_NEAR(s.melt_temperature, melt, 1e-6 * melt);
            EXPECT_EQ(s.temperature, s.melt_temperature);
            EXPECT_NEAR(s.melt_fraction, share, 1e-5);
          }
        EXPECT_EQ(at(thermal, density, onset - 1e-5).melt_fraction, 0.);
        EXPECT_EQ(at(thermal, density, onset - 1e-5).temperature, at(frozen, density, onset - 1e-5).temperature);
        const State liquid = at(thermal, density, onset + fusion + 10. * cv);
        EXPECT_EQ(liquid.melt_fraction, 1.);
        EXPECT_NEAR(liquid.temperature, melt + 10., 1e-2);
      }
  }

  TEST(ThermalModel, BoilsOnlyWhereItHasExpanded)
  {
    const ConstantSpecificHeat thermal(aluminium(), with_phases());
    const auto                 t = thermal.transitions();
    EXPECT_DOUBLE_EQ(t.vapour_complete, t.vapour_onset + 0.109);
    const auto line = [&](double energy) { return at(thermal, released(aluminium(), energy), energy); };
    EXPECT_EQ(line(0.99 * t.vapour_onset).vapour_fraction, 0.);
    EXPECT_NEAR(line(t.vapour_onset).temperature, 2792., 1e-3);
    EXPECT_NEAR(line(t.vapour_onset).vapour_fraction, 0., 1e-6);
    EXPECT_NEAR(line(t.vapour_complete).vapour_fraction, 1., 1e-6);
    EXPECT_NEAR(line(t.vapour_complete).temperature, 2792., 1e-3);
    const State half = line(0.5 * (t.vapour_onset + t.vapour_complete));
    EXPECT_NEAR(half.temperature, 2792., 1e-9);
    EXPECT_GT(half.vapour_fraction, 0.4);
    EXPECT_LT(half.vapour_fraction, 0.8);
    EXPECT_EQ(half.melt_fraction, 1.);
    EXPECT_EQ(at(thermal, reference_density, 0.1).vapour_fraction, 0.);
    EXPECT_GT(at(thermal, reference_density, 0.1).temperature, 5000.);
  }

  TEST(ThermalModel, NeedsNoLawThatHoldsOrReleasesItsVapour)
  {
    MaterialRequest request;
    request.equation_of_state = "linear polynomial";
    request.thermal_model     = "constant specific heat";
    request.library           = "aluminium 6061-T6"; // takes more energy to expand than there is: the whole heat boils
    const Material aluminium  = make_material(request);
    const auto     t          = aluminium.thermal->transitions();
    EXPECT_NEAR(t.vapour_complete - t.vapour_onset, 0.109, 1e-12);
    const double onset  = released(*aluminium.eos, t.vapour_onset);
    const State  boiled = at(*aluminium.thermal, onset, t.vapour_onset + 0.0545);
    EXPECT_NEAR(boiled.vapour_fraction, 0.5, 1e-6);
    request.library     = "lead"; // K mu cannot hold it to the boiling point
    const Material lead = make_material(request);
    EXPECT_TRUE(std::isinf(lead.thermal->transitions().vapour_onset));
    EXPECT_TRUE(std::isfinite(lead.thermal->transitions().melt_complete));
    EXPECT_EQ(at(*lead.thermal, 5., 0.05).vapour_fraction, 0.);
  }

  TEST(ThermalModel, TemperatureIsContinuous)
  {
    const ConstantSpecificHeat thermal(aluminium(), with_phases());
    for (const double energy : {0.004, 0.007, 0.012, 0.04, 0.09, 0.2})
      {
        double last = at(thermal, 0.8, energy).temperature;
        for (double density = 0.8; density < 4.5; density += 1e-5)
          {
            const double next = at(thermal, density, energy).temperature;
            // the steepest place: up to 15000 K boil away over 0.02 of v, 1.5 times as steep in the middle
            ASSERT_LT(std::abs(next - last), 1e-5 * reference_density / (density * density) * 1.5 / 0.02 * 15000.)
                << density << " " << energy;
            last = next;
          }
      }
  }

  TEST(ThermalModel, NearTheAluminiumOfAneos)
  {
    // The aluminium of [Thompson1972] melts at P = 0 from 0.664 to 1.062 MJ/kg above its reference. A
    // specific heat of 300 K is too small for hot aluminium: short of both, by 8.1 and 5.1 %.
    const auto t = ConstantSpecificHeat(aluminium(), with_phases()).transitions();
    EXPECT_NEAR(t.melt_onset, 0.00664, 0.085 * 0.00664);
    EXPECT_NEAR(t.melt_complete, 0.01062, 0.055 * 0.01062);
    // Temperatures of its Hugoniot, density [g/cm^3], T [eV], e - e0 [1e10 erg/g].
    const ConstantSpecificHeat solid(aluminium(), solid_only());
    const double               rows[][3] = {{3.6049, 0.10, 2.1527}, {3.8770, 0.18, 3.9659}, {4.2078, 0.35, 7.2438}};
    for (const auto &[density, eV, energy] : rows)
      EXPECT_NEAR(at(solid, density * reference_density / 2.70, energy * 0.01).temperature, eV * 11604.5,
                  0.095 * eV * 11604.5);
  }

  TEST(ThermalModel, EveryLibraryMaterialMeltsAndBoils)
  {
    for (const MaterialConstants &m : material_library())
      {
        SCOPED_TRACE(m.name);
        MaterialRequest request;
        request.library                       = m.name;
        request.thermal_model                 = "constant specific heat";
        const Material                  metal = make_material(request);
        const ThermalModel::Transitions t     = metal.thermal->transitions();
        EXPECT_GT(t.melt_onset, 0.);
        EXPECT_GT(t.melt_complete, t.melt_onset);
        EXPECT_GT(t.vapour_onset, t.melt_complete);
        EXPECT_GT(t.vapour_complete, t.vapour_onset);
        EXPECT_TRUE(std::isfinite(t.vapour_complete));
        // The heat up to the melting point, per atom: 3 k (T_m - 300 K) within a third.
        EXPECT_NEAR(t.melt_onset / (m.specific_heat * (at(*metal.thermal, m.density, 0.).melt_temperature - 300.)),
                    0.85, 0.2);
      }
  }

  TEST(ThermalModel, SameBitsInAnyPlaceOfTheBatch)
  {
    const ConstantSpecificHeat thermal(aluminium(), with_phases());
    std::vector<double>        density, energy;
    for (int i = 0; i < 1000; ++i)
      {
        density.push_back(0.5 + 0.004 * ((i * 37) % 1000));
        energy.push_back(2e-4 * ((i * 91) % 1000));
      }
    std::vector<double> temperature(1000), melt_temperature(1000), melt(1000), vapour(1000), alone(1000);
    thermal.evaluate(density, energy, {temperature, melt_temperature, melt, vapour});
    thermal.evaluate(density, energy, {{}, {}, alone, {}});
    EXPECT_EQ(alone, melt);
    for (int i = 0; i < 1000; ++i)
      {
        const State s = at(thermal, density[i], energy[i]);
        ASSERT_EQ(s.temperature, temperature[i]);
        ASSERT_EQ(s.melt_temperature, melt_temperature[i]);
        ASSERT_EQ(s.melt_fraction, melt[i]);
        ASSERT_EQ(s.vapour_fraction, vapour[i]);
      }
  }

  TEST(ThermalModel, SaysWhatIsWrong)
  {
    const auto wrong = [](auto change) {
      auto constants = with_phases();
      change(constants);
      EXPECT_THROW(ConstantSpecificHeat(aluminium(), constants), InputError);
    };
    wrong([](auto &c) { c.specific_heat = 0.; });
    wrong([](auto &c) { c.reference_temperature = -1.; });
    wrong([](auto &c) { c.reference_temperature = 1000.; });
    wrong([](auto &c) { c.heat_of_fusion = 0.; });
    wrong([](auto &c) { c.boiling_point = 900.; });
    wrong([](auto &c) { c.heat_of_vaporisation = -1.; });
    wrong([](auto &c) { c.melting_point = ConstantSpecificHeat::infinite; });
    // A gas has no state without pressure to melt in.
    EXPECT_THROW(ConstantSpecificHeat(IdealGas(1.4, 1.), with_phases()), InputError);

    MaterialRequest request;
    request.library                    = "aluminium 6061-T6";
    request.thermal_model              = "constant specific heat";
    request.constants["Boiling point"] = 800.;
    EXPECT_NE(complaint(request).find("boiling point = 800 K: must be > 933.5"), std::string::npos);
  }

  TEST(ThermalModel, ComesFromTheEquationOfStateWhereItHasOne)
  {
    const auto gas = std::make_shared<const KnowingGas>();
    EXPECT_EQ(equation_of_state_temperature(gas).get(), static_cast<const ThermalModel *>(gas.get()));
    MaterialRequest request;
    request.library       = "aluminium 6061-T6";
    request.thermal_model = "equation of state";
    EXPECT_NE(complaint(request).find("'mie-grueneisen' gives no temperature; the equations of state that do: "),
              std::string::npos);
  }
} // namespace whipple
