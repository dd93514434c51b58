// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Numbers with units, "6.58 km/s", to and from the internal units cm, g, us, K (and so Mbar).
///
/// Grammar: NUMBER [UNIT], UNIT = FACTOR {('/' | '*' | blank) FACTOR}, FACTOR = SYMBOL ['^' INTEGER] | '(' UNIT ')'.
/// A '/' divides by the one factor that follows it: "J/kg/K" or "J/(kg K)". Symbols are case sensitive
/// (MPa is not mPa). Every decimal unit is an exact power of ten, applied to the digits as written, so "6.58 km/s"
/// is the double nearest to 0.658.
namespace whipple::units
{
  /// Exponents of length, mass, time, temperature and angle.
  struct Dimension
  {
    int length = 0, mass = 0, time = 0, temperature = 0, angle = 0;

    bool
    operator==(const Dimension &) const = default;
  };

  /// What a key of a scene file measures.
  struct Quantity
  {
    const char *name;      ///< "velocity"
    Dimension   dimension; ///< of one component
    const char *unit;      ///< internal unit, "cm/us"; empty for pure numbers
    const char *example;   ///< "6.58 km/s"
  };

  inline constexpr Quantity number{"pure number", {0, 0, 0, 0}, "", "0.5"};
  inline constexpr Quantity length{"length", {1, 0, 0, 0}, "cm", "0.081 cm"};
  inline constexpr Quantity time{"time", {0, 0, 1, 0}, "us", "1.5 us"};
  inline constexpr Quantity velocity{"velocity", {1, 0, -1, 0}, "cm/us", "6.58 km/s"};
  inline constexpr Quantity density{"density", {-3, 1, 0, 0}, "g/cm^3", "2.7 g/cm^3"};
  inline constexpr Quantity pressure{"pressure", {-1, 1, -2, 0}, "Mbar", "345 MPa"};
  inline constexpr Quantity specific_energy{"specific energy", {2, 0, -2, 0}, "Mbar cm^3/g", "1 MJ/kg"};
  inline constexpr Quantity energy{"energy", {2, 1, -2, 0}, "Mbar cm^3", "25 kJ"};
  inline constexpr Quantity void_rate{"void growth coefficient", {-2, 0, 1, 0}, "us/cm^2", "1e3 us/cm^2"};
  inline constexpr Quantity temperature{"temperature", {0, 0, 0, 1}, "K", "933 K"};
  inline constexpr Quantity specific_heat{"specific heat", {2, 0, -2, -1}, "Mbar cm^3/g/K", "863 J/kg/K"};

  inline constexpr Quantity conductivity{"heat conductivity", {1, 1, -3, -1}, "Mbar cm^2/us/K", "237 W/m/K"};
  inline constexpr Quantity inverse_pressure{"inverse pressure", {1, -1, 2, 0}, "Mbar^-1", "6.52 Mbar^-1"};
  inline constexpr Quantity inverse_temperature{"inverse temperature", {0, 0, 0, -1}, "K^-1", "6.16e-4 K^-1"};
  inline constexpr Quantity rate{"rate", {0, 0, -1, 0}, "us^-1", "1 s^-1"};
  inline constexpr Quantity angle{"angle", {0, 0, 0, 0, 1}, "deg", "30 deg"};
  inline constexpr Quantity surface_energy{"energy per area", {0, 1, -2, 0}, "Mbar cm", "20 kJ/m^2"};

  /// The quantity of that name ("velocity"), null if there is none.
  const Quantity *
  find_quantity(std::string_view name);

  /// Value of "NUMBER UNIT" in internal units.
  /// @throws InputError saying what is wrong and what is allowed (without file and key: the caller adds them) if the
  /// number cannot be read or is not finite, or its unit is missing, unknown or of another dimension.
  double
  parse(std::string_view text, const Quantity &quantity);

  /// Components of "NUMBER UNIT, NUMBER UNIT, ..."; each carries its unit.
  /// @throws InputError as parse, or if there are not `components` of them.
  std::vector<double>
  parse_list(std::string_view text, const Quantity &quantity, std::size_t components);

  /// "VALUE UNIT" in internal units with the fewest digits that read back to the same bits.
  std::string
  format(double value, const Quantity &quantity);

  /// Symbols of all units, for messages and help.
  std::vector<std::string>
  symbols();
} // namespace whipple::units
