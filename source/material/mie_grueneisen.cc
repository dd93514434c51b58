// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/common_constants.h>
#include <whipple/material/mie_grueneisen.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>
#include <whipple/material/reference_curve.h>

namespace whipple
{
  MieGrueneisen::MieGrueneisen(const Constants &given_constants)
    : constants(given_constants)
  {
    require_positive(name(), "density", constants.reference_density, "g/cm^3");
    require_positive(name(), "sound speed", constants.sound_speed, "cm/us");
    require_not_negative(name(), "Hugoniot slope", constants.hugoniot_slope, "");
    require_positive(name(), "Grueneisen coefficient", constants.grueneisen, "");
  }

  void
  MieGrueneisen::evaluate(std::span<const double> true_density, std::span<const double> energy,
                          std::span<double> pressure, std::span<double> sound_speed_squared) const
  {
    const double         reference_density = constants.reference_density;
    const double         inverse           = 1. / reference_density;
    const double         c0c0              = constants.sound_speed * constants.sound_speed;
    const LinearHugoniot hugoniot{constants.hugoniot_slope};
    const double         grueneisen    = constants.grueneisen;
    const double         bulk_modulus  = reference_density * c0c0;
    const double         thermal       = grueneisen * reference_density;
    const double         thermal_slope = grueneisen * inverse;

    const std::size_t n = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const double         v         = reference_density / true_density[i];
        const ReferenceCurve reference = reference_curve(hugoniot, true_density[i] * inverse, v, grueneisen);
        const double         p         = bulk_modulus * reference.pressure + thermal * energy[i];
        pressure[i]                    = p;
        // (P / gamma^2) dP/de = P (Gamma0 / gamma0) v^2
        sound_speed_squared[i] = c0c0 * reference.slope + thermal_slope * p * (v * v);
      }
  }

  void
  MieGrueneisen::derivatives(std::span<const double> true_density, std::span<const double>,
                             std::span<double> dp_ddensity, std::span<double> dp_de) const
  {
    const double         reference_density = constants.reference_density;
    const double         inverse           = 1. / reference_density;
    const double         c0c0              = constants.sound_speed * constants.sound_speed;
    const LinearHugoniot hugoniot{constants.hugoniot_slope};
    const double         grueneisen = constants.grueneisen;
    const double         thermal    = grueneisen * reference_density;

    const std::size_t n = true_density.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        dp_ddensity[i] =
            c0c0 *
            reference_curve(hugoniot, true_density[i] * inverse, reference_density / true_density[i], grueneisen).slope;
        dp_de[i] = thermal;
      }
  }

  double
  MieGrueneisen::energy_of_pressure(double true_density, double pressure) const
  {
    check_density(true_density);
    const double reference_density = constants.reference_density;
    const double reference         = reference_density * constants.sound_speed * constants.sound_speed *
                             reference_curve(LinearHugoniot{constants.hugoniot_slope}, true_density / reference_density,
                                             reference_density / true_density, constants.grueneisen)
                                 .pressure;
    return (pressure - reference) / (constants.grueneisen * reference_density);
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

  namespace
  {
    ModelDescription
    description()
    {
      using namespace common_constants;
      return {.name    = "mie-grueneisen",
              .summary = "solid about its Hugoniot U_s = c0 + s u",
              .documentation =
                  "Pressure on the Hugoniot K chi / (1 - s chi)^2, chi = 1 - gamma0/gamma, and off it "
                  "Gamma0 gamma0 times the difference in energy. In expansion a linear law with a cubic term "
                  "that keeps a zero of the pressure however hot the material is. No phases: what melts or "
                  "boils keeps the pressure of a hot solid.",
              .constants = {density, sound_speed, hugoniot_slope, grueneisen},
              .source    = "doc/theory/equation_of_state.md; constants: the library",
              .published = {}};
    }

    const Registration<EquationOfState> registration(description(), [](const ModelInput &c) {
      return std::make_shared<MieGrueneisen>(
          MieGrueneisen::Constants{c("Density"), c("Sound speed"), c("Hugoniot slope"), c("Grueneisen coefficient")});
    });
  } // namespace
} // namespace whipple
