// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>
#include <utility>

/// Ways in which energy changes its form that statistics.csv and summary.json list in every run, with 0 where they
/// never happened. Each is registered where it is booked; what is booked and not registered is listed where it
/// happened.
namespace whipple
{
  /// Filled before main() by the one line
  ///
  ///     const ConversionRegistration registration(40, "remap", ConversionRegistry::Listed::each_step);
  ///
  /// in the file that books it; never changed afterwards.
  class ConversionRegistry
  {
  public:
    enum class Listed
    {
      each_step, ///< a column of statistics.csv, and a number of summary.json
      at_end     ///< a number of summary.json
    };

    /// Place in the order, then the cause as it is booked.
    using Key = std::pair<int, std::string>;

    static const std::map<Key, Listed> &
    all()
    {
      return entries();
    }

  private:
    friend class ConversionRegistration;

    static std::map<Key, Listed> &
    entries()
    {
      static std::map<Key, Listed> map;
      return map;
    }
  };

  class ConversionRegistration
  {
  public:
    ConversionRegistration(int place, const std::string &cause, ConversionRegistry::Listed listed)
    {
      ConversionRegistry::entries()[{place, cause}] = listed;
    }
  };

  /// What energy converted by a cause is called: "viscous work", "conducted heat", "remap loss".
  inline std::string
  conversion_name(const std::string &cause)
  {
    return cause.ends_with("work") || cause.ends_with("heat") ? cause : cause + " loss";
  }
} // namespace whipple
