// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/study_plan.h>

#include <optional>
#include <string>
#include <vector>

/// Cell sizes to choose from: coarse ones to learn from, fine ones to reach a tolerance with.
namespace whipple
{
  /// How a scene is set on cells of another size: the domain must be what it was, so root cells that would stick out
  /// of it are made smaller by fewer levels.
  struct CellSetting
  {
    double cell   = 0; ///< cm
    int    levels = 0; ///< of refinement

    /// As overrides of a scene. `origin`: where they come from, for messages.
    std::vector<PrmStatement>
    overrides(const std::string &origin) const;
  };

  /// The setting of a scene (with overrides) on cells of this size; none if the scene refuses them or they do not fill
  /// its domain.
  std::optional<CellSetting>
  fit_cell(const std::string &scene_file, std::vector<PrmStatement> overrides, double cell);

  /// The section with a cell axis to choose from. An axis it has goes on to finer cells (3/4, 1/2, 3/8 ... of its
  /// finest, down to 1/16) as far as the domain allows, if it moves nothing else. Without one it gets one around the
  /// scene's own cell h: 8 h, 4 h, 2 h to learn from, which together cost a sixth of a run at h, 1.5 h, h, then down to
  /// h / 16; without those that do not fill the domain or are larger than half of the thinnest body. Of a study with
  /// one axis at a time only the cell axis stays, the others at their base.
  /// @throws InputError if the scene does not take three coarse sizes.
  StudySection
  with_cell_ladder(const StudyOptions &options, StudySection section);
} // namespace whipple
