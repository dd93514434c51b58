// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

/// Entries of a scene's section that belong to something which registers itself: they stand in its own file, and the
/// rooms of the scene need not know what they mean.
namespace whipple
{
  struct SectionEntry
  {
    std::string key, default_value, documentation;
  };

  /// What the scene says in these entries. All throw InputError that names file, key, value and what is allowed.
  struct SectionInput
  {
    std::function<std::string(const std::string &key)>                        text;
    std::function<int(const std::string &key, int lower, int upper)>          integer;
    std::function<double(const std::string &key, double lower, double upper)> number;
    std::function<double(const std::string &key)>                             length; ///< positive, cm
    /// Which of the allowed names it is.
    std::function<std::size_t(const std::string &key, const std::vector<std::string> &allowed)> choice;
  };
} // namespace whipple
