// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/material_factory.h>
#include <whipple/material/material_library.h>
#include <whipple/material/model_input.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace whipple
{
  ModelInput::ModelInput(const ModelDescription &description, const MaterialRequest &request)
    : description_(description)
    , request_(request)
  {
  }

  const ModelConstant &
  ModelInput::constant(const std::string &key) const
  {
    const auto found = std::find_if(description_.constants.begin(), description_.constants.end(),
                                    [&](const ModelConstant &c) { return c.key == key; });
    if (found == description_.constants.end())
      throw std::logic_error("model '" + description_.name + "' reads '" + key + "', which it does not describe");
    return *found;
  }

  bool
  ModelInput::given(const std::string &key) const
  {
    return request_.constants.count(key) > 0;
  }

  std::optional<double>
  ModelInput::find(const std::string &key) const
  {
    const ModelConstant &description = constant(key);
    const auto           value       = [&]() -> std::optional<double> {
      if (const auto scene = request_.constants.find(key); scene != request_.constants.end())
        return scene->second;
      if (const auto published = published_constant(description_, request_.library, key))
        return published;
      return description.default_value;
    }();
    if (value && !description.range.contains(*value))
      {
        std::ostringstream message;
        message << key << " = " << *value << ": must be " << description.range.text();
        throw InputError(message.str());
      }
    return value;
  }

  double
  ModelInput::operator()(const std::string &key) const
  {
    if (const auto value = find(key))
      return *value;
    std::string near; // materials of a longer name that have it: "copper OFHC" for "copper"
    if (!request_.library.empty())
      for (const std::string &name : material_names())
        if (name.starts_with(request_.library + ' ') && published_constant(description_, name, key))
          near += (near.empty() ? ", or take Library = '" : "' or '") + name;
    throw InputError(key + " is needed by '" + description_.name + "', and " +
                     (request_.library.empty() ? "no library material is named"
                                               : "the library does not have it for '" + request_.library + "'") +
                     ": give it" + (near.empty() ? "" : near + "'"));
  }

  std::string
  ModelInput::text(const std::string &key) const
  {
    constant(key);
    const auto found = request_.texts.find(key);
    if (found == request_.texts.end())
      throw InputError(key + " is needed by '" + description_.name + "': give it");
    return found->second;
  }
} // namespace whipple
