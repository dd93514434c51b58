// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// Values a constant of a model may take.
  struct Range
  {
    double lower          = -std::numeric_limits<double>::infinity();
    double upper          = std::numeric_limits<double>::infinity();
    bool   lower_excluded = false;
    bool   infinite       = false; ///< infinity itself has a meaning ("infinite" in scenes)

    static Range
    any()
    {
      return {};
    }
    static Range
    positive()
    {
      return {.lower = 0., .lower_excluded = true};
    }
    static Range
    not_negative()
    {
      return {.lower = 0.};
    }
    static Range
    not_negative_or_infinite()
    {
      return {.lower = 0., .infinite = true};
    }
    static Range
    above(double bound)
    {
      return {.lower = bound, .lower_excluded = true};
    }
    static Range
    fraction()
    {
      return {.lower = 0., .upper = 1.};
    }

    /// Not-a-number is outside of every range.
    bool
    contains(double value) const;

    /// What is allowed, for messages and the manual: "> 0", ">= 0 or infinite", "0 ... 1", "any".
    std::string
    text() const;
  };

  /// One constant of a model, set by its key in a scene's section Materials/NAME. Models that mean the same thing share
  /// the key.
  struct ModelConstant
  {
    std::string           key;      ///< "Hugoniot slope"
    std::string           quantity; ///< "pure number", "pressure" ...: names of scene/units.h; "text": a name or file
    std::string           documentation; ///< what it is: "s of U_s = c0 + s u_p"
    Range                 range = Range::any();
    std::optional<double> default_value;    ///< internal units; none: from the library or the scene
    bool                  optional = false; ///< may be missing altogether (ModelInput::find)
  };

  /// What a source gives for one material, by key; internal units.
  struct PublishedConstants
  {
    std::string                   material; ///< "aluminium 6061-T6"
    std::map<std::string, double> constants;
    std::string                   source;
    std::string                   caution; ///< what to know before trusting them; empty if nothing
  };

  /// All that is to know about a model: for selection in scenes, `whipple help effects`, messages and the manual.
  struct ModelDescription
  {
    std::string                     name;          ///< in scene files, "mie-grueneisen"
    std::string                     summary;       ///< one line
    std::string                     documentation; ///< a paragraph: equation, where it holds, what to look out for
    std::vector<ModelConstant>      constants;
    std::string                     source;    ///< of the model: paper, report
    std::vector<PublishedConstants> published; ///< constants of materials that only this model uses
  };
} // namespace whipple
