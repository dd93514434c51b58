// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/parameter_check.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// P_ref / K and (gamma0 / K) dP_ref/dgamma of the reference curve, a function of v = gamma0/gamma alone.
    /// Both branches are computed and the right one taken, so that loops over it vectorise.
    struct ReferenceCurve
    {
      double pressure;
      double slope;
    };

    inline ReferenceCurve
    reference_curve(double gamma_over_gamma0, double v, double s, double grueneisen)
    {
      const double chi         = std::max(1. - v, 0.);
      const double steepening  = 1. / (1. - s * chi);
      const double steepening2 = steepening * steepening;
      const double mu          = std::min(gamma_over_gamma0 - 1., 0.);
      const double mu2         = mu * mu;

      const double compressed_slope = v * v * (1. + (s - grueneisen) * chi) * steepening2 * steepening;
      const double expanded_slope   = 1. + mu2 * (2. + v) * v;
      // One of chi and mu is zero, and with it its term.
      return {chi * (1. - 0.5 * grueneisen * chi) * steepening2 + mu * (1. + mu2 * v),
              chi > 0. ? compressed_slope : expanded_slope};
    }
  } // namespace

  MieGrueneisen::MieGrueneisen(const Constants &constants)
    : constants(constants)
  {
    require_positive(name(), "density", constants.reference_density, "g/cm^3");
    require_positive(name(), "sound speed", constants.sound_speed, "cm/us");
    require_not_negative(name(), "Hugoniot slope", constants.hugoniot_slope, "");
    require_positive(name(), "Grueneisen coefficient", constants.grueneisen, "");
  }

  void
  MieGrueneisen::evaluate(std::span<const double> gamma, std::span<const double> energy, std::span<double> pressure,
                          std::span<double> sound_speed_squared) const
  {
    const double gamma0        = constants.reference_density;
    const double inverse       = 1. / gamma0;
    const double c0c0          = constants.sound_speed * constants.sound_speed;
    const double s             = constants.hugoniot_slope;
    const double grueneisen    = constants.grueneisen;
    const double bulk_modulus  = gamma0 * c0c0;
    const double thermal       = grueneisen * gamma0;
    const double thermal_slope = grueneisen * inverse;

    const std::size_t n = gamma.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const double         v         = gamma0 / gamma[i];
        const ReferenceCurve reference = reference_curve(gamma[i] * inverse, v, s, grueneisen);
        const double         p         = bulk_modulus * reference.pressure + thermal * energy[i];
        pressure[i]                    = p;
        // (P / gamma^2) dP/de = P (Gamma0 / gamma0) v^2
        sound_speed_squared[i] = c0c0 * reference.slope + thermal_slope * p * (v * v);
      }
  }

  void
  MieGrueneisen::derivatives(std::span<const double> gamma, std::span<const double>, std::span<double> dp_dgamma,
                             std::span<double> dp_de) const
  {
    const double gamma0     = constants.reference_density;
    const double inverse    = 1. / gamma0;
    const double c0c0       = constants.sound_speed * constants.sound_speed;
    const double s          = constants.hugoniot_slope;
    const double grueneisen = constants.grueneisen;
    const double thermal    = grueneisen * gamma0;

    const std::size_t n = gamma.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        dp_dgamma[i] = c0c0 * reference_curve(gamma[i] * inverse, gamma0 / gamma[i], s, grueneisen).slope;
        dp_de[i]     = thermal;
      }
  }

  double
  MieGrueneisen::energy_of_pressure(double gamma, double pressure) const
  {
    check_density(gamma);
    const double gamma0 = constants.reference_density;
    const double reference =
        gamma0 * constants.sound_speed * constants.sound_speed *
        reference_curve(gamma / gamma0, gamma0 / gamma, constants.hugoniot_slope, constants.grueneisen).pressure;
    return (pressure - reference) / (constants.grueneisen * gamma0);
  }

  double
  MieGrueneisen::reference_density() const
  {
    return constants.reference_density;
  }

  double
  MieGrueneisen::max_density() const
  {
    const double s = constants.hugoniot_slope;
    return s > 1. ? constants.reference_density * s / (s - 1.) : EquationOfState::max_density();
  }

  std::string
  MieGrueneisen::name() const
  {
    return "mie-grueneisen";
  }
} // namespace whipple
