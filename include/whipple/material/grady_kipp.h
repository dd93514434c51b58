// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/fragment_model.h>

#include <optional>

namespace whipple
{
  /// Fragment size from the balance of local kinetic energy of expansion and energy of new surface: with the fracture
  /// toughness K_Ic expressed by the fracture energy W = K_Ic^2 / (2 rho c^2) per area,
  ///
  ///   s = [sqrt(24) K_Ic / (rho c rate)]^(2/3) = [48 W / (rho rate^2)]^(1/3),
  ///
  /// infinite where nothing expands (rate <= 0). In a liquid the surface tension takes the place of W; where part x of
  /// the mass is molten, (1 - x) W + x tension does. doc/theory/fragments.md.
  class GradyKipp : public FragmentModel
  {
  public:
    /// @param fracture_energy  W [Mbar cm = 1e9 J/m^2]
    /// @param surface_tension  of the liquid [Mbar cm]; not given: melt breaks like the solid
    /// @throws InputError unless both are > 0.
    explicit GradyKipp(double fracture_energy, std::optional<double> surface_tension = std::nullopt);

    void
    evaluate(std::span<const double> density, std::span<const double> sound_speed, std::span<const double> strain_rate,
             std::span<const double> melt_fraction, std::span<double> size) const override;
    std::string
    name() const override;

  private:
    double fracture_energy_, surface_tension_;
  };

  /// W [Mbar cm] of a fracture toughness [Mbar cm^(1/2); 1 MPa m^(1/2) = 1e-4], with density [g/cm^3] and sound speed
  /// [cm/us] of the sound material.
  constexpr double
  fracture_energy(double toughness, double density, double sound_speed)
  {
    return toughness * toughness / (2. * density * sound_speed * sound_speed);
  }
} // namespace whipple
