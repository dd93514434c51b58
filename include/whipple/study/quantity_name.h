// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <vector>

namespace whipple
{
  /// A key of summary.json for people: "hole_diameter_cm" is "hole diameter" in "cm".
  struct QuantityName
  {
    std::string words, unit; ///< the unit is empty for verdicts and pure numbers
  };

  /// Take the unit off the end of a key.
  QuantityName
  split_quantity(const std::string &key);

  /// "hole diameter, cm"
  std::string
  readable_quantity(const std::string &key);

  /// Unit of the errors of a field of an exact solution ("density": "g/cm^3"); empty if the field is not known.
  std::string
  field_unit(const std::string &field);

  /// Value of "0.02 cm" or "200 um" in `unit`, one of those that split_quantity and field_unit give.
  /// @throws InputError (without key) saying what is allowed.
  double
  parse_in_unit(const std::string &text, const std::string &unit);

  /// A number with so many significant digits, "0.0123"; "1.2e-05" where that is shorter.
  std::string
  digits(double value, int significant);

  /// The words of a name in lower case: split at blanks and at all that is no letter or digit.
  std::vector<std::string>
  words_of_name(const std::string &name);
} // namespace whipple
