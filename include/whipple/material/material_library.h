// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// Published constants of one material, as data.
  struct MaterialConstants
  {
    std::string name;             ///< "aluminium 2024-T4"
    double      density;          ///< gamma0 [g/cm^3]
    double      sound_speed;      ///< c0 of U_s = c0 + s u_p [cm/us]
    double      hugoniot_slope;   ///< s
    double      grueneisen;       ///< Gamma0
    double      shear_modulus;    ///< G [Mbar]
    double      yield_stress;     ///< Y in simple tension, unworked [Mbar]
    double      specific_heat;    ///< [Mbar cm^3 / (g K)]; 1 J/(kg K) = 1e-8
    double      melt_temperature; ///< of the source's melting model at gamma0 [K], not the handbook value
    std::string source;           ///< where the numbers come from
    std::string caution;          ///< what to know before trusting them; empty if nothing

    /// The constant that models know by this key ("Density", ModelConstant::key); empty if it is none of these.
    std::optional<double>
    find(const std::string &key) const;
  };

  /// All materials that Whipple knows by name, alphabetically.
  const std::vector<MaterialConstants> &
  material_library();

  /// Constants of the material of that name.
  /// @throws InputError that lists the names there are.
  const MaterialConstants &
  find_material(const std::string &name);

  /// The same, null where there is none of that name.
  const MaterialConstants *
  find_in_library(const std::string &name);

  /// All materials that the library or the source of any model has constants of, alphabetically.
  std::vector<std::string>
  material_names();

  /// Heating [K] that a rise of the specific internal energy [Mbar cm^3/g] means at constant specific heat
  /// and zero pressure; for reports, not for models.
  double
  temperature_rise(const MaterialConstants &constants, double energy_rise);
} // namespace whipple
