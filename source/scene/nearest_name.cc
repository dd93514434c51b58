// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/nearest_name.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace whipple
{
  namespace
  {
    /// Levenshtein distance, case ignored.
    std::size_t
    edits(std::string_view a, std::string_view b)
    {
      const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };

      std::vector<std::size_t> row(b.size() + 1);
      std::iota(row.begin(), row.end(), 0);
      for (std::size_t i = 0; i < a.size(); ++i)
        {
          std::size_t diagonal = row[0];
          row[0]               = i + 1;
          for (std::size_t j = 0; j < b.size(); ++j)
            {
              const std::size_t replaced = diagonal + (lower(a[i]) != lower(b[j]));
              diagonal                   = row[j + 1];
              row[j + 1]                 = std::min({replaced, row[j] + 1, diagonal + 1});
            }
        }
      return row.back();
    }
  } // namespace

  std::string
  name_choices(std::string_view wrong, const std::vector<std::string> &allowed)
  {
    if (allowed.empty())
      return "none is allowed here";
    const auto nearest =
        std::min_element(allowed.begin(), allowed.end(),
                         [&](const std::string &a, const std::string &b) { return edits(wrong, a) < edits(wrong, b); });
    std::string text;
    if (!wrong.empty() && edits(wrong, *nearest) <= std::max<std::size_t>(2, wrong.size() / 3))
      text = "did you mean '" + *nearest + "'? ";
    text += allowed.size() == 1 ? "allowed is " : "allowed are ";
    for (std::size_t i = 0; i < allowed.size(); ++i)
      text += (i ? ", " : "") + allowed[i];
    return text;
  }
} // namespace whipple
