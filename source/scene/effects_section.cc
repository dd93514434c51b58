// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/sections.h>

#include <algorithm>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Effects";
  }

  std::vector<std::string>
  effect_names()
  {
    return {"strength", "voids", "body tags"};
  }

  void
  declare_effects(SceneParameters &parameters)
  {
    SceneSection(parameters, path)
        .declare("List", "",
                 "any of: strength, voids, body tags; an effect left out costs nothing and carries no field");
  }

  std::vector<std::string>
  read_effects(SceneParameters &parameters)
  {
    const SceneSection       section(parameters, path);
    std::vector<std::string> effects;
    for (const std::string &name : section.list("List"))
      {
        section.name_index("List", name, effect_names());
        if (std::find(effects.begin(), effects.end(), name) != effects.end())
          section.reject("List", "'" + name + "' is listed twice; allowed is once");
        effects.push_back(name);
      }
    return effects;
  }
} // namespace whipple::sections
