// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/common_constants.h>
#include <whipple/material/linear_polynomial.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace whipple
{
  namespace
  {
    struct Pressure
    {
      double value;
      double dp_dmu;
      double dp_dE; ///< E per reference volume
    };

    inline Pressure
    polynomial(const LinearPolynomial::Constants &c, double mu, double energy_per_volume)
    {
      const double positive = std::max(mu, 0.);
      const double thermal  = c.c4 + c.c5 * mu + c.c6 * positive * positive;
      return {c.c1 * mu + c.c2 * positive * positive + c.c3 * mu * mu * mu + thermal * energy_per_volume,
              c.c1 + 2. * c.c2 * positive + 3. * c.c3 * mu * mu + (c.c5 + 2. * c.c6 * positive) * energy_per_volume,
              thermal};
    }
  } // namespace

  LinearPolynomial::Constants
  LinearPolynomial::expansion_of(const MieGrueneisen::Constants &law)
  {
    const double s            = law.hugoniot_slope;
    const double grueneisen   = law.grueneisen;
    const double bulk_modulus = law.reference_density * law.sound_speed * law.sound_speed;
    Constants    expansion;
    expansion.reference_density = law.reference_density;
    expansion.c1                = bulk_modulus;
    expansion.c2                = bulk_modulus * (2. * s - 1. - 0.5 * grueneisen);
    expansion.c3                = bulk_modulus * (s - 1.) * (3. * s - 1. - grueneisen);
    expansion.c4                = grueneisen;
    return expansion;
  }

  LinearPolynomial::LinearPolynomial(const Constants &given_constants)
    : constants(given_constants)
  {
    require_positive(name(), "density", constants.reference_density, "g/cm^3");
    require_positive(name(), "c1", constants.c1, "Mbar");
    for (const double c : {constants.c2, constants.c3, constants.c4, constants.c5, constants.c6})
      if (!std::isfinite(c))
        throw InputError(name() + ": c2 ... c6 must be finite numbers");
  }

  void
  LinearPolynomial::evaluate(std::span<const double> true_density, std::span<const double> energy,
                             std::span<double> pressure, std::span<double> sound_speed_squared) const
  {
    const Constants   c                 = constants;
    const double      reference_density = c.reference_density;
    const double      inverse           = 1. / reference_density;
    const std::size_t n                 = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const double   v       = reference_density / true_density[i];
        const Pressure p       = polynomial(c, true_density[i] * inverse - 1., reference_density * energy[i]);
        pressure[i]            = p.value;
        sound_speed_squared[i] = inverse * (p.dp_dmu + p.value * p.dp_dE * (v * v));
      }
  }

  void
  LinearPolynomial::derivatives(std::span<const double> true_density, std::span<const double> energy,
                                std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    const Constants   c                 = constants;
    const double      reference_density = c.reference_density;
    const double      inverse           = 1. / reference_density;
    const std::size_t n                 = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const Pressure p = polynomial(c, true_density[i] * inverse - 1., reference_density * energy[i]);
        dp_ddensity[i]   = p.dp_dmu * inverse;
        dp_de[i]         = p.dp_dE * reference_density;
      }
  }

  double
  LinearPolynomial::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    const double   reference_density = constants.reference_density;
    const Pressure cold              = polynomial(constants, true_density / reference_density - 1., 0.);
    if (cold.dp_dE == 0.)
      {
        std::ostringstream message;
        message << name() << ": pressure does not depend on energy at density " << true_density
                << " g/cm^3 (c4 + c5 mu + c6 mu^2 = 0); no energy gives " << pressure << " Mbar";
        throw StateError(message.str());
      }
    return (pressure - cold.value) / (cold.dp_dE * reference_density);
  }

  double
  LinearPolynomial::reference_density() const
  {
    return constants.reference_density;
  }

  std::string
  LinearPolynomial::name() const
  {
    return "linear polynomial";
  }

  namespace
  {
    ModelConstant
    coefficient(const std::string &key, const std::string &quantity, const std::string &term)
    {
      return {key, quantity, "coefficient of " + term + " in the linear polynomial", Range::any(), {}, true};
    }

    /// Needed only where c1 is not given.
    ModelConstant
    optional(ModelConstant constant)
    {
      constant.optional = true;
      return constant;
    }

    ModelDescription
    description()
    {
      using namespace common_constants;
      return {
          .name          = "linear polynomial",
          .summary       = "DYNA form 1, as in 1993",
          .documentation = "P = c1 mu + c2 max(mu, 0)^2 + c3 mu^3 + (c4 + c5 mu + c6 max(mu, 0)^2) gamma0 e, "
                           "mu = gamma/gamma0 - 1. Without C1, all six are the expansion of the mie-grueneisen law of "
                           "the same material to third order.",
          .constants     = {density, optional(sound_speed), optional(hugoniot_slope), optional(grueneisen),
                            coefficient("C1", "pressure", "mu"), coefficient("C2", "pressure", "max(mu, 0)^2"),
                            coefficient("C3", "pressure", "mu^3"), coefficient("C4", "pure number", "E"),
                            coefficient("C5", "pure number", "mu E"), coefficient("C6", "pure number", "max(mu, 0)^2 E")},
          .source        = "E. P. Fahrenthold, Int. J. Impact Engng 14 (1993) 229-240, equation (8b)",
          .published     = {}};
    }

    std::shared_ptr<const EquationOfState>
    make(const ModelInput &c)
    {
      LinearPolynomial::Constants polynomial{.reference_density = c("Density")};
      if (!c.find("C1"))
        polynomial = LinearPolynomial::expansion_of(
            {c("Density"), c("Sound speed"), c("Hugoniot slope"), c("Grueneisen coefficient")});
      polynomial.c1 = c.find("C1").value_or(polynomial.c1);
      polynomial.c2 = c.find("C2").value_or(polynomial.c2);
      polynomial.c3 = c.find("C3").value_or(polynomial.c3);
      polynomial.c4 = c.find("C4").value_or(polynomial.c4);
      polynomial.c5 = c.find("C5").value_or(polynomial.c5);
      polynomial.c6 = c.find("C6").value_or(polynomial.c6);
      return std::make_shared<LinearPolynomial>(polynomial);
    }

    const Registration<EquationOfState> registration(description(), make);
  } // namespace
} // namespace whipple
