// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/material/model_description.h>

#include <cmath>
#include <sstream>

namespace whipple
{
  bool
  Range::contains(double value) const
  {
    if (std::isnan(value))
      return false;
    if (std::isinf(value))
      return infinite && value > 0.;
    return (lower_excluded ? value > lower : value >= lower) && value <= upper;
  }

  std::string
  Range::text() const
  {
    std::ostringstream text;
    if (std::isfinite(lower) && std::isfinite(upper))
      text << lower << " ... " << upper;
    else if (std::isfinite(lower))
      text << (lower_excluded ? "> " : ">= ") << lower;
    else if (std::isfinite(upper))
      text << "<= " << upper;
    else
      text << "any";
    if (infinite)
      text << " or infinite";
    return text.str();
  }
} // namespace whipple
