// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/stage_end.h>

namespace whipple
{
  std::shared_ptr<const StageEnd>
  StageEndRegistry::read(StageEndInput input)
  {
    const std::string text = input.rest;
    if (text.empty())
      input.reject("must be given; allowed are " + usage());
    const auto begins = [&](const std::string &phrase) {
      return text.starts_with(phrase) && (phrase.empty() || text.size() == phrase.size() || text[phrase.size()] == ' ');
    };
    // the map is ordered and the empty phrase fits all: of those that fit, the longest comes last
    auto found = all().begin();
    for (auto entry = all().begin(); entry != all().end(); ++entry)
      if (begins(entry->first))
        found = entry;
    const std::size_t rest = text.find_first_not_of(' ', found->first.size());
    input.rest             = rest == std::string::npos ? "" : text.substr(rest);
    return found->second.make(input);
  }

  std::string
  StageEndRegistry::usage()
  {
    std::string text;
    for (const auto &[phrase, entry] : all())
      text += (text.empty() ? "" : " | ") + entry.usage;
    return text;
  }
} // namespace whipple
