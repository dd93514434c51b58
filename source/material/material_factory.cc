// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/equilibrium_void_law.h>
#include <whipple/material/ideal_gas.h>
#include <whipple/material/isothermal.h>
#include <whipple/material/linear_hardening.h>
#include <whipple/material/linear_polynomial.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/perfectly_plastic.h>
#include <whipple/material/rate_void_law.h>
#include <whipple/material/stiffened_gas.h>

#include <algorithm>
#include <functional>
#include <sstream>

namespace whipple
{
  namespace
  {
    /// One constant that a request may give: what it is called, where the request holds it, and where the
    /// library has it (null: the library has no such thing).
    struct Constant
    {
      const char           *name;
      std::optional<double> MaterialRequest::*given;
      double MaterialConstants::*published;
    };
    using Request   = MaterialRequest;
    using Published = MaterialConstants;
    const Constant density{"density", &Request::density, &Published::density};
    const Constant sound_speed{"sound speed", &Request::sound_speed, &Published::sound_speed};
    const Constant hugoniot_slope{"Hugoniot slope", &Request::hugoniot_slope, &Published::hugoniot_slope};
    const Constant grueneisen{"Grueneisen coefficient", &Request::grueneisen, &Published::grueneisen};
    const Constant adiabatic_exponent{"adiabatic exponent", &Request::adiabatic_exponent, nullptr};
    const Constant shear_modulus{"shear modulus", &Request::shear_modulus, &Published::shear_modulus};
    const Constant yield_stress{"yield stress", &Request::yield_stress, &Published::yield_stress};
    const Constant hardening_modulus{"hardening modulus", &Request::hardening_modulus, nullptr};
    const Constant c1{"c1", &Request::c1, nullptr}, c2{"c2", &Request::c2, nullptr}, c3{"c3", &Request::c3, nullptr},
        c4{"c4", &Request::c4, nullptr}, c5{"c5", &Request::c5, nullptr}, c6{"c6", &Request::c6, nullptr};

    /// The request with the library behind it.
    class Constants
    {
    public:
      explicit Constants(const MaterialRequest &request)
        : request(request)
        , library(request.library.empty() ? nullptr : &find_material(request.library))
      {
      }

      bool
      gives(const Constant &constant) const
      {
        return (request.*constant.given).has_value();
      }

      double
      operator()(const Constant &constant) const
      {
        if (gives(constant))
          return *(request.*constant.given);
        if (library && constant.published)
          return library->*constant.published;
        throw InputError(
            std::string(constant.name) + " is needed by the models chosen, and " +
            (library ? "the library does not have it for '" + library->name + "'" : "no library material is named") +
            ": give it");
      }

      double
      or_else(const Constant &constant, double otherwise) const
      {
        return gives(constant) ? *(request.*constant.given) : otherwise;
      }

      const MaterialRequest   &request;
      const MaterialConstants *library;
    };

    /// One row of a registry: the kind, the constants it may use, and how it is made.
    template <class Model>
    struct Registration
    {
      ModelKind                                                      kind;
      std::vector<Constant>                                          uses;
      std::function<std::shared_ptr<const Model>(const Constants &)> make;
    };

    MieGrueneisen::Constants
    mie_grueneisen_constants(const Constants &c)
    {
      return {c(density), c(sound_speed), c(hugoniot_slope), c(grueneisen)};
    }

    /// c1 ... c6 as given; without c1, the expansion of the Mie-Grueneisen law in mu to third order.
    std::shared_ptr<const EquationOfState>
    make_linear_polynomial(const Constants &c)
    {
      LinearPolynomial::Constants polynomial{.reference_density = c(density)};
      if (!c.gives(c1))
        polynomial = LinearPolynomial::expansion_of(mie_grueneisen_constants(c));
      polynomial.c1 = c.or_else(c1, polynomial.c1);
      polynomial.c2 = c.or_else(c2, polynomial.c2);
      polynomial.c3 = c.or_else(c3, polynomial.c3);
      polynomial.c4 = c.or_else(c4, polynomial.c4);
      polynomial.c5 = c.or_else(c5, polynomial.c5);
      polynomial.c6 = c.or_else(c6, polynomial.c6);
      return std::make_shared<LinearPolynomial>(polynomial);
    }

    const std::vector<Registration<EquationOfState>> &
    equations_of_state()
    {
      static const std::vector<Registration<EquationOfState>> registry = {
          {{"mie-grueneisen", "solid about its Hugoniot U_s = c0 + s u: density, sound speed, Hugoniot slope, "
                              "Grueneisen coefficient"},
           {density, sound_speed, hugoniot_slope, grueneisen},
           [](const Constants &c) { return std::make_shared<MieGrueneisen>(mie_grueneisen_constants(c)); }},
          {{"linear polynomial", "DYNA form 1, as in 1993: density, c1 ... c6; without c1 the expansion of "
                                 "mie-grueneisen"},
           {density, sound_speed, hugoniot_slope, grueneisen, c1, c2, c3, c4, c5, c6},
           make_linear_polynomial},
          {{"ideal gas", "gamma law: adiabatic exponent, density"},
           {adiabatic_exponent, density},
           [](const Constants &c) { return std::make_shared<IdealGas>(c(adiabatic_exponent), c(density)); }},
          {{"stiffened gas", "liquid or soft solid: density, sound speed, adiabatic exponent"},
           {density, sound_speed, adiabatic_exponent},
           [](const Constants &c) {
             return std::make_shared<StiffenedGas>(
                 StiffenedGas::Constants{c(density), c(sound_speed), c(adiabatic_exponent)});
           }},
      };
      return registry;
    }

    const std::vector<Registration<Strength>> &
    strengths()
    {
      static const std::vector<Registration<Strength>> registry = {
          {{"none", "hydrodynamic"}, {}, [](const Constants &) { return nullptr; }},
          {{"perfectly plastic", "shear modulus, yield stress"},
           {shear_modulus, yield_stress},
           [](const Constants &c) { return std::make_shared<PerfectlyPlastic>(c(shear_modulus), c(yield_stress)); }},
          {{"linear hardening", "shear modulus, yield stress, hardening modulus"},
           {shear_modulus, yield_stress, hardening_modulus},
           [](const Constants &c) {
             return std::make_shared<LinearHardening>(
                 LinearHardening::Constants{c(shear_modulus), c(yield_stress), c(hardening_modulus)});
           }},
      };
      return registry;
    }

    const std::vector<Registration<VoidLaw>> &
    void_laws()
    {
      static const std::vector<Registration<VoidLaw>> registry = {
          {{"none", "no voids, and no field for them"}, {}, [](const Constants &) { return nullptr; }},
          {{"rate", "(8c) of the 1993 paper above a spall threshold: alpha, spall strength"},
           {},
           [](const Constants &c) { return std::make_shared<RateVoidLaw>(c.request.alpha, c.request.spall_strength); }},
          {{"equilibrium", "no pressure where there are voids, above a spall threshold: spall strength"},
           {},
           [](const Constants &c) { return std::make_shared<EquilibriumVoidLaw>(c.request.spall_strength); }},
      };
      return registry;
    }

    template <class Model>
    std::vector<ModelKind>
    kinds(const std::vector<Registration<Model>> &registry)
    {
      std::vector<ModelKind> result;
      for (const auto &row : registry)
        result.push_back(row.kind);
      return result;
    }

    template <class Model>
    const Registration<Model> &
    find(const std::vector<Registration<Model>> &registry, const std::string &what, const std::string &name)
    {
      for (const auto &row : registry)
        if (row.kind.name == name)
          return row;
      std::string allowed;
      for (const auto &row : registry)
        allowed += (allowed.empty() ? "" : " | ") + row.kind.name;
      throw InputError(what + " = '" + name + "': must be " + allowed);
    }

    /// A constant that no chosen model reads is a misunderstanding: say so instead of ignoring it.
    void
    reject_unused(const Constants &constants, const std::vector<Constant> &used)
    {
      for (const Constant &constant : {density, sound_speed, hugoniot_slope, grueneisen, adiabatic_exponent,
                                       shear_modulus, yield_stress, hardening_modulus, c1, c2, c3, c4, c5, c6})
        if (constants.gives(constant) &&
            std::none_of(used.begin(), used.end(), [&](const Constant &u) { return u.given == constant.given; }))
          {
            std::ostringstream message;
            message << constant.name << " = " << constants(constant) << ": no use to equation of state '"
                    << constants.request.equation_of_state << "' with strength '" << constants.request.strength
                    << "': leave it out";
            throw InputError(message.str());
          }
    }
  } // namespace

  std::vector<ModelKind>
  equation_of_state_kinds()
  {
    return kinds(equations_of_state());
  }

  std::vector<ModelKind>
  strength_kinds()
  {
    return kinds(strengths());
  }

  std::vector<ModelKind>
  void_law_kinds()
  {
    return kinds(void_laws());
  }

  Material
  make_material(const MaterialRequest &request)
  {
    const Constants constants(request);
    const auto     &eos      = find(equations_of_state(), "equation of state", request.equation_of_state);
    const auto     &strength = find(strengths(), "strength", request.strength);
    const auto     &void_law = find(void_laws(), "void law", request.void_law);

    std::vector<Constant> used = eos.uses;
    used.insert(used.end(), strength.uses.begin(), strength.uses.end());
    reject_unused(constants, used);

    Material material;
    material.name       = request.name.empty() ? request.library : request.name;
    material.source     = constants.library ? constants.library->source : "the scene";
    material.eos        = eos.make(constants);
    material.strength   = strength.make(constants);
    material.void_law   = void_law.make(constants);
    material.isothermal = request.isothermal;
    if (request.isothermal)
      material.eos = std::make_shared<IsothermalEquationOfState>(material.eos);
    return material;
  }
} // namespace whipple
