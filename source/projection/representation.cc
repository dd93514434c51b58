// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/representation.h>

#include <algorithm>
#include <stdexcept>

namespace whipple
{
  std::shared_ptr<const Representation>
  RepresentationRegistry::make(const std::string &name)
  {
    const Entry &entry  = all().at(name);
    const auto   preset = [&](const std::string &key) {
      for (const SectionEntry &e : entry.entries)
        if (e.key == key)
          return e.default_value;
      throw std::out_of_range("representation '" + name + "' has no entry '" + key + "'");
    };
    const auto none_given = [](const std::string &key, auto...) -> double {
      throw std::out_of_range("no number is given for '" + key + "'");
    };
    const auto chosen = [&](const std::string &key, const std::vector<std::string> &allowed) -> std::size_t {
      return std::find(allowed.begin(), allowed.end(), preset(key)) - allowed.begin();
    };
    return entry.read({preset, none_given, none_given, none_given, chosen});
  }

  std::string
  RepresentationRegistry::usage()
  {
    std::string text;
    for (const auto &[name, entry] : all())
      text += (text.empty() ? "" : " | ") + name + " (" + entry.summary + ")";
    return text;
  }
} // namespace whipple
