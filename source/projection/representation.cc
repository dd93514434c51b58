// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/projection/representation.h>

#include <stdexcept>

namespace whipple
{
  std::shared_ptr<const Representation>
  RepresentationRegistry::make(const std::string &name)
  {
    const Entry &entry  = all().at(name);
    const auto   preset = [&](const std::string &key) {
      for (const RepresentationEntry &e : entry.entries)
        if (e.key == key)
          return e.default_value;
      throw std::out_of_range("representation '" + name + "' has no entry '" + key + "'");
    };
    return entry.read({preset, [](const std::string &key) -> double {
                         throw std::out_of_range("no length is given for '" + key + "'");
                       }});
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
