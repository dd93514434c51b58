// SPDX-License-Identifier: LGPL-2.1-or-later
// Coggeshall's free expansions against the equations themselves, and the factory of exact solutions.
#include "exact_flow_check.h"

#include <whipple/error.h>
#include <whipple/exact/coggeshall.h>
#include <whipple/exact/exact_factory.h>

#include <set>

namespace
{
  using namespace whipple;
  using exact::Coggeshall;

  TEST(ExactCoggeshall, SolvesTheEulerEquations)
  {
    for (int n = 1; n <= 3; ++n)
      for (const double power : {-1., 0., 1. / 7., 2.})
        for (const double time : {1., 2.5})
          {
            const Coggeshall        cloud({n, 1.4, power, 1.3, 0.02});
            const exact_check::Flow gas{n, [](double density, double energy) {
                                          return exact::FluidPoint{density, energy, 0.4 * density * energy, 0.};
                                        }};
            exact_check::expect_euler(gas, cloud, {0.2, 2.}, time);
          }
  }

  exact::ExactRequest<2>
  request(const std::string &name)
  {
    exact::ExactRequest<2> r;
    r.name     = name;
    r.geometry = exact::Geometry::spherical;
    r.symmetry = Symmetry::axisymmetric;
    r.upper    = {{2., 2.}};
    r.start    = 1.;
    exact::BodyState<2> body;
    body.name                                      = "gas";
    body.constants.equation_of_state               = "ideal gas";
    body.constants.constants["Adiabatic exponent"] = 1.4;
    body.constants.constants["Density"]            = 1.;
    body.material                                  = make_material(body.constants);
    body.upper                                     = r.upper;
    body.density                                   = 1.;
    r.bodies                                       = {body};
    for (const exact::ExactKind &kind : exact::exact_kinds<2>())
      if (kind.name == name)
        for (const exact::ExactConstant &constant : kind.constants)
          r.constants[constant.key] = constant.default_value;
    return r;
  }

  /// What makes the eighth solution one of conduction too: r^(n-1) rho^alpha T^(beta+3) dT/dr does not change with r.
  TEST(ExactCoggeshall, ConductsWithoutDivergence)
  {
    const auto solution = exact::make_exact_solution(request("coggeshall 8"));
    const auto flux     = [&](double r) {
      const auto   temperature = [&](double at) { return solution->at({{at, 0.}}, 0.).energy / 0.025; };
      const double slope       = exact_check::derivative([&](double d) { return temperature(r + d); }, 1e-4);
      return r * r / solution->at({{r, 0.}}, 0.).density * std::pow(temperature(r), 5.) * slope;
    };
    EXPECT_NEAR(flux(1.5), flux(0.5), 1e-8 * std::abs(flux(0.5)));
    EXPECT_LT(flux(0.5), -0.1);
  }

  TEST(ExactCoggeshall, RimSpoilsWhatItsSignalReaches)
  {
    const auto solution = exact::make_exact_solution(request("coggeshall 1"));
    EXPECT_TRUE(solution->counts({{1.99, 0.}}, 0.));
    EXPECT_FALSE(solution->counts({{2.01, 0.}}, 0.));
    // the rim itself moves out with u = r/t, the signal less c = 0.118 cm/us
    EXPECT_TRUE(solution->counts({{2.08, 0.}}, 0.1));
    EXPECT_FALSE(solution->counts({{2.19, 0.}}, 0.1));
  }

  TEST(ExactFactory, NamesAreUniqueAndUnknownOnesListThem)
  {
    std::set<std::string> names;
    for (const exact::ExactKind &kind : exact::exact_kinds<2>())
      {
        EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
        EXPECT_FALSE(kind.description.empty());
      }
    try
      {
        exact::make_exact_solution(request("nho"));
        FAIL() << "an unknown name must be refused";
      }
    catch (const InputError &error)
      {
        EXPECT_NE(std::string(error.what()).find("| noh |"), std::string::npos) << error.what();
      }
  }

  TEST(ExactFactory, RefusesScenesThatAreNotTheProblem)
  {
    auto planar     = request("noh");
    planar.symmetry = Symmetry::planar;
    EXPECT_THROW(exact::make_exact_solution(planar), InputError);
    auto solid                                  = request("sedov");
    solid.bodies[0].constants.equation_of_state = "mie-grueneisen";
    EXPECT_THROW(exact::make_exact_solution(solid), InputError);
    EXPECT_THROW(exact::make_exact_solution(request("sedov")), InputError);    // no energy
    EXPECT_THROW(exact::make_exact_solution(request("riemann")), InputError);  // one body, spherical
    EXPECT_THROW(exact::make_exact_solution(request("guderley")), InputError); // starts after the collapse
    auto late  = request("coggeshall 1");
    late.start = 0;
    EXPECT_THROW(exact::make_exact_solution(late), InputError);
  }

  /// The deposit of a scene that shows half of space is half of the explosion's energy.
  TEST(ExactFactory, SedovReadsTheDeposit)
  {
    auto half               = request("sedov");
    half.start              = 0;
    half.bodies[0].deposit  = 0.5 * 0.85107185;
    half.boundaries[2].kind = BoundaryKind::reflecting;
    EXPECT_NEAR(*exact::make_exact_solution(half)->shock_position(1.), 1., 1e-8);
    auto full              = half;
    full.lower             = {{0., -2.}};
    full.bodies[0].deposit = 0.85107185;
    EXPECT_NEAR(*exact::make_exact_solution(full)->shock_position(1.), 1., 1e-8);
  }
} // namespace
