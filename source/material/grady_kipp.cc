// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/grady_kipp.h>
#include <whipple/material/model_registry.h>
#include <whipple/material/parameter_check.h>

#include <cmath>
#include <limits>

namespace whipple
{
  GradyKipp::GradyKipp(double fracture_energy, std::optional<double> surface_tension)
    : fracture_energy_(fracture_energy)
    , surface_tension_(surface_tension.value_or(fracture_energy))
  {
    require_positive(name(), "fracture energy", fracture_energy, "Mbar cm");
    require_positive(name(), "surface tension", surface_tension_, "Mbar cm");
  }

  void
  GradyKipp::evaluate(std::span<const double> density, std::span<const double>, std::span<const double> strain_rate,
                      std::span<const double> melt_fraction, std::span<double> size) const
  {
    const std::size_t n = size.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        const double rate = strain_rate[i], melt = melt_fraction.empty() ? 0. : melt_fraction[i];
        const double surface_energy = fracture_energy_ + melt * (surface_tension_ - fracture_energy_);
        size[i]                     = rate > 0. ? std::cbrt(48. * surface_energy / (density[i] * rate * rate))
                                                : std::numeric_limits<double>::infinity();
      }
  }

  std::string
  GradyKipp::name() const
  {
    return "grady-kipp";
  }

  namespace
  {
    constexpr double MPa_sqrt_m = 1e-4; // in Mbar cm^(1/2)

    /// Surface tension of liquid aluminium at its melting point, 0.9 J/m^2 in Mbar cm.
    constexpr double liquid_aluminium = 0.9e-9;

    PublishedConstants
    published(const char *material, double toughness, double density, double sound_speed)
    {
      return {material,
              {{"Fracture energy", fracture_energy(toughness * MPa_sqrt_m, density, sound_speed)},
               {"Surface tension", liquid_aluminium}},
              "K_Ic and surface tension of handbooks; density and sound speed: the library",
              "fracture toughness and surface tension from memory, not checked against a handbook; toughness varies by "
              "a third with direction and plate, surface tension by a fifth with oxide"};
    }

    ModelDescription
    description()
    {
      return {
          .name    = "grady-kipp",
          .summary = "fragment size where kinetic energy of expansion pays for new surface",
          .documentation =
              "s = [48 W / (rho rate^2)]^(1/3) with the rate of volume expansion at failure and the fracture "
              "energy W = "
              "K_Ic^2 / (2 rho c^2), so the usual (sqrt(24) K_Ic / (rho c rate))^(2/3). For brittle fracture of "
              "expanding solid at rates where flaws do not matter. With the effect melting and a surface tension, "
              "W falls to it as the mass melts, (1 - x) W + x tension: melt makes fragments twenty times smaller. "
              "Used where debris is laid down as fragments (Representation); else a diagnostic.",
          .constants = {{"Fracture energy",
                         "energy per area",
                         "W = K_Ic^2 / (2 rho c^2); 30 MPa m^(1/2) in aluminium: 5.7 kJ/m^2",
                         Range::positive(),
                         {},
                         false},
                        {"Surface tension",
                         "energy per area",
                         "of the liquid, in the place of W; aluminium: 0.9 J/m^2. Not given: melt breaks like solid",
                         Range::positive(),
                         {},
                         true}},
          .source    = "D. E. Grady and M. E. Kipp, Int. J. Rock Mech. 17 (1980) 147-157; D. E. Grady, J. Mech. "
                       "Phys. Solids 36 (1988) 353-384; from memory",
          .published = {published("aluminium 2024-T4", 30., 2.785, 0.5328),
                        published("aluminium 6061-T6", 29., 2.703, 0.5240),
                        published("aluminium 7075-T6", 27., 2.803, 0.5200)}};
    }

    const Registration<FragmentModel> registration(description(), [](const ModelInput &c) {
      return std::make_shared<GradyKipp>(c("Fracture energy"), c.find("Surface tension"));
    });
  } // namespace
} // namespace whipple
