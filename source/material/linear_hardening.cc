// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/common_constants.h>
#include <whipple/material/linear_hardening.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>

#include <algorithm>

namespace whipple
{
  LinearHardening::LinearHardening(const Constants &given_constants)
    : constants(given_constants)
  {
    require_positive(name(), "shear modulus", constants.shear_modulus, "Mbar");
    require_not_negative(name(), "yield stress", constants.yield_stress, "Mbar");
    require_not_negative(name(), "hardening modulus", constants.hardening_modulus, "Mbar");
  }

  void
  LinearHardening::evaluate(const StrengthInput &state, std::span<double> shear_modulus,
                            std::span<double> yield_stress) const
  {
    std::fill(shear_modulus.begin(), shear_modulus.end(), constants.shear_modulus);
    const double      yield0    = constants.yield_stress;
    const double      hardening = constants.hardening_modulus;
    const std::size_t n         = yield_stress.size();
    for (std::size_t i = 0; i < n; ++i)
      yield_stress[i] = yield0 + hardening * state.plastic_strain[i];
  }

  double
  LinearHardening::reference_shear_modulus() const
  {
    return constants.shear_modulus;
  }

  std::string
  LinearHardening::name() const
  {
    return "linear hardening";
  }

  namespace
  {
    ModelDescription
    description()
    {
      return {
          .name    = "linear hardening",
          .summary = "constant shear modulus, yield stress growing linearly with the plastic strain",
          .documentation =
              "Y = Y0 + H eps_p with the equivalent plastic strain eps_p; the shear modulus is constant. The strength "
              "of the 1993 multi-plate debris: G 0.250, Y0 3.45e-3, H 6.67e-2 Mbar. H is the plastic hardening "
              "modulus; "
              "a tangent modulus E_t of older input decks means H = E E_t/(E - E_t) with Young's modulus E. Nothing "
              "ends the hardening: look at the plastic strains before trusting it at large ones.",
          .constants = {common_constants::shear_modulus,
                        common_constants::yield_stress,
                        {"Hardening modulus", "pressure", "H = dY/d(eps_p)", Range::not_negative(), {}, false}},
          .source    = "E. P. Fahrenthold, Int. J. Impact Engng 14 (1993) 229-240",
          .published = {}};
    }

    const Registration<Strength> registration(description(), [](const ModelInput &c) {
      return std::make_shared<LinearHardening>(
          LinearHardening::Constants{c("Shear modulus"), c("Yield stress"), c("Hardening modulus")});
    });
  } // namespace
} // namespace whipple
