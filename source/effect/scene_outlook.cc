// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/effect/scene_outlook.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace whipple
{
  bool
  SceneOutlook::is_known() const
  {
    return !encounter.empty() &&
           std::all_of(encounter.begin(), encounter.end(), [](const Encounter &e) { return e.is_known; });
  }

  double
  SceneOutlook::largest(double Encounter::*number) const
  {
    double value = 0;
    for (const Encounter &e : encounter)
      value = std::max(value, e.*number);
    return value;
  }

  double
  SceneOutlook::least(double Encounter::*number) const
  {
    double value = std::numeric_limits<double>::infinity();
    for (const Encounter &e : encounter)
      value = std::min(value, e.*number);
    return value;
  }

  bool
  SceneOutlook::is_porous() const
  {
    return std::any_of(materials.begin(), materials.end(), [](const NamedMaterial &material) {
      return material.model.void_law && material.model.void_law->initial_void_fraction() > 0.;
    });
  }

  EffectVerdict
  off_without_model(const std::string &key)
  {
    return {"", false, {}, "no material names a model (Materials/NAME/" + key + ")"};
  }

  EffectVerdict
  kept_unknown()
  {
    return {"", true, {}, "kept: no one-dimensional impact to judge by"};
  }

  std::string
  rounded(double value)
  {
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
  }
} // namespace whipple
