// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>

namespace whipple
{
  /// A text as it stands inside of quotes in an XML file.
  inline std::string
  xml(std::string_view text)
  {
    std::string escaped;
    for (const char c : text)
      switch (c)
        {
        case '&':
          escaped += "&amp;";
          break;
        case '<':
          escaped += "&lt;";
          break;
        case '"':
          escaped += "&quot;";
          break;
        default:
          escaped += c;
        }
    return escaped;
  }
} // namespace whipple
