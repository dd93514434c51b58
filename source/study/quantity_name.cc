// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/units.h>
#include <whipple/study/quantity_name.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>

namespace whipple
{
  namespace
  {
    struct Unit
    {
      const char     *suffix; ///< of keys in summary.json
      units::Quantity quantity;
    };

    constexpr units::Quantity mass{"mass", {0, 1, 0, 0}, "g", "0.01 g"};
    constexpr units::Quantity momentum{"momentum", {1, 1, -1, 0}, "g cm/us", "0.01 g cm/us"};

    /// Longer suffixes before those they end with.
    const std::array<Unit, 8> all_units{{{"_g_cm_per_us", momentum},
                                         {"_cm_per_us", units::velocity},
                                         {"_cm", units::length},
                                         {"_us", units::time},
                                         {"_g", mass},
                                         {"_g_per_cm3", units::density},
                                         {"_Mbar_cm3_per_g", units::specific_energy},
                                         {"_Mbar", units::pressure}}};

    constexpr const char *degrees_suffix = "_deg", *degrees = "deg";
  } // namespace

  QuantityName
  split_quantity(const std::string &key)
  {
    QuantityName name{key, ""};
    const auto   take = [&](const std::string &suffix, const char *unit) {
      if (!name.unit.empty() || !key.ends_with(suffix))
        return;
      name = {key.substr(0, key.size() - suffix.size()), unit};
    };
    for (const Unit &unit : all_units)
      take(unit.suffix, unit.quantity.unit);
    take(degrees_suffix, degrees);
    std::replace(name.words.begin(), name.words.end(), '_', ' ');
    return name;
  }

  std::string
  readable_quantity(const std::string &key)
  {
    const QuantityName name = split_quantity(key);
    return name.words + (name.unit.empty() ? "" : ", " + name.unit);
  }

  std::string
  field_unit(const std::string &field)
  {
    for (const auto &[name, quantity] : {std::pair<std::string, units::Quantity>{"density", units::density},
                                         {"velocity", units::velocity},
                                         {"pressure", units::pressure},
                                         {"energy", units::specific_energy},
                                         {"shock position", units::length}})
      if (name == field)
        return quantity.unit;
    return {};
  }

  double
  parse_in_unit(const std::string &text, const std::string &unit)
  {
    if (unit == degrees)
      {
        const std::size_t end = text.rfind(degrees);
        if (end == std::string::npos || end + std::string(degrees).size() != text.size())
          throw InputError("the unit is missing; allowed is an angle such as 0.5 deg");
        return units::parse(text.substr(0, end), units::number);
      }
    for (const Unit &known : all_units)
      if (unit == known.quantity.unit)
        return units::parse(text, known.quantity);
    return units::parse(text, units::number);
  }

  std::string
  digits(double value, int significant)
  {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.*g", significant, value);
    return text.data();
  }

  std::vector<std::string>
  words_of_name(const std::string &name)
  {
    std::vector<std::string> words{""};
    for (const char c : name)
      if (std::isalnum(static_cast<unsigned char>(c)))
        words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      else if (!words.back().empty())
        words.emplace_back();
    if (words.back().empty())
      words.pop_back();
    return words;
  }
} // namespace whipple
