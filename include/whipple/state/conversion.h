// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/registry.h>

#include <string>
#include <utility>

/// Ways in which energy changes its form that statistics.csv and summary.json list in every run, with 0 where they
/// never happened. Each is registered where it is booked; what is booked and not registered is listed where it
/// happened.
namespace whipple
{
  /// Where they are listed.
  enum class ConversionListed
  {
    each_step, ///< a column of statistics.csv, and a number of summary.json
    at_end     ///< a number of summary.json
  };

  /// By place in the order, then the cause as it is booked.
  class ConversionRegistry : public Registry<ConversionRegistry, ConversionListed, std::pair<int, std::string>>
  {
  };

  /// One line in the file that books it:
  ///
  ///     const ConversionRegistration registration({40, "remap"}, ConversionListed::each_step);
  using ConversionRegistration = ConversionRegistry::Registered;

  /// What energy converted by a cause is called: "viscous work", "conducted heat", "remap loss".
  inline std::string
  conversion_name(const std::string &cause)
  {
    return cause.ends_with("work") || cause.ends_with("heat") ? cause : cause + " loss";
  }
} // namespace whipple
