// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/problem/problem.h>
#include <whipple/scene/units.h>
#include <whipple/study/cell_ladder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    constexpr const char *levels_parameter = "Mesh/Levels";

    constexpr std::array<double, 8> finer_factors{{3. / 4, 1. / 2, 3. / 8, 1. / 4, 3. / 16, 1. / 8, 3. / 32, 1. / 16}};

    /// Corners that differ by less than this part of a cell are the same.
    constexpr double same_corner = 1e-6;

    bool
    same_domain(const Scene<2> &a, const Scene<2> &b)
    {
      for (int d = 0; d < 2; ++d)
        if (std::abs(a.upper_corner()[d] - b.upper_corner()[d]) > same_corner * b.lattice.spacing)
          return false;
      return true;
    }

    std::vector<PrmStatement>
    fixed_overrides(const StudyOptions &options, const StudySection &section)
    {
      std::vector<PrmStatement> overrides = section.overrides;
      for (const std::string &text : options.overrides)
        if (const PrmStatement statement = read_override(text); !belongs_to_study(statement))
          overrides.push_back(statement);
      return overrides;
    }

    StudyValue
    value_of(const CellSetting &setting, bool with_levels)
    {
      StudyValue value;
      value.label = units::format(setting.cell, units::length);
      value.parts = {value.label};
      if (with_levels)
        value.parts.push_back(std::to_string(setting.levels));
      value.cell = setting.cell;
      return value;
    }

    std::vector<CellSetting>
    fit_cells(const std::string &scene_file, const std::vector<PrmStatement> &overrides, double cell,
              const std::vector<double> &factors)
    {
      std::vector<CellSetting> settings;
      for (const double factor : factors)
        if (const auto setting = fit_cell(scene_file, overrides, factor * cell))
          settings.push_back(*setting);
      return settings;
    }

    /// Half of the smallest extent of a body, as far as it does not reach across the whole domain: with larger cells a
    /// run says nothing about finer ones.
    double
    coarsest_cell(const Scene<2> &scene)
    {
      double smallest = std::numeric_limits<double>::infinity();
      for (const Body<2> &body : scene.bodies)
        {
          const Box<2> box = extent(body.shape);
          for (int d = 0; d < 2; ++d)
            {
              const double lower = std::max(box.lower[d], scene.lattice.origin[d]);
              const double upper = std::min(box.upper[d], scene.upper_corner()[d]);
              if (upper - lower < (1. - same_corner) * (scene.upper_corner()[d] - scene.lattice.origin[d]))
                smallest = std::min(smallest, upper - lower);
            }
          if (!body.shape->is_box())
            smallest = std::min(smallest, body.shape->least_thickness({}));
        }
      return 0.5 * smallest;
    }

    StudyAxis
    new_cell_axis(const StudySection &section, const std::vector<PrmStatement> &overrides)
    {
      const Scene<2>           scene = read_varied_problem<2>(section.scene_file, overrides).scene;
      const double             cell  = scene.lattice.spacing;
      std::vector<CellSetting> settings;
      for (const double factor : {8., 4., 2., 1.5, 1.})
        if (const auto setting = fit_cell(section.scene_file, overrides, factor * cell);
            setting && setting->cell <= coarsest_cell(scene))
          settings.push_back(*setting);
      if (settings.size() < 3)
        throw InputError(section.scene_file +
                         ": does not take three cell sizes from 8 times its own down over its whole domain; "
                         "give it a section Study with a cell axis of three values or more");
      const std::vector<CellSetting> finer =
          fit_cells(section.scene_file, overrides, cell, {finer_factors.begin(), finer_factors.end()});
      settings.insert(settings.end(), finer.begin(), finer.end());
      StudyAxis axis;
      axis.name       = "cell";
      axis.parameters = {cell_parameter, levels_parameter};
      axis.origin     = section.scene_file;
      for (const CellSetting &setting : settings)
        axis.values.push_back(value_of(setting, true));
      return axis;
    }

    /// Finer cells for an axis that moves nothing but the cells.
    void
    extend(StudyAxis &axis, const StudySection &section, const std::vector<PrmStatement> &overrides)
    {
      const double finest = *axis.values[axis.base].cell;
      const int    levels = read_varied_problem<2>(section.scene_file, overrides).scene.lattice.max_level;
      for (const CellSetting &setting :
           fit_cells(section.scene_file, overrides, finest, {finer_factors.begin(), finer_factors.end()}))
        if (setting.levels == levels)
          axis.values.push_back(value_of(setting, false));
    }
  } // namespace

  std::vector<PrmStatement>
  CellSetting::overrides(const std::string &origin) const
  {
    std::vector<PrmStatement> statements{
        read_override(std::string(cell_parameter) + " = " + units::format(cell, units::length)),
        read_override(std::string(levels_parameter) + " = " + std::to_string(levels))};
    for (PrmStatement &statement : statements)
      statement.origin = origin;
    return statements;
  }

  std::optional<CellSetting>
  fit_cell(const std::string &scene_file, std::vector<PrmStatement> overrides, double cell)
  {
    const Scene<2>    scene = read_varied_problem<2>(scene_file, overrides).scene;
    const std::size_t size  = overrides.size();
    for (int levels = scene.lattice.max_level; levels >= 0; --levels)
      {
        const CellSetting setting{cell, levels};
        overrides.resize(size);
        for (PrmStatement &statement : setting.overrides(scene_file))
          overrides.push_back(statement);
        try
          {
            if (same_domain(read_varied_problem<2>(scene_file, overrides).scene, scene))
              return setting;
          }
        catch (const InputError &)
          {
            // this many levels do not go with these cells; fewer may
          }
      }
    return std::nullopt;
  }

  StudySection
  with_cell_ladder(const StudyOptions &options, StudySection section)
  {
    const std::vector<PrmStatement> overrides = fixed_overrides(options, section);
    if (section.combination == Combination::one_at_a_time)
      {
        section.combination = Combination::product;
        for (StudyAxis &axis : section.axes)
          if (!axis.is_cell_axis())
            {
              axis.values = {axis.values[axis.base]};
              axis.base   = 0;
            }
      }
    const auto cell_axis = section.cell_axis();
    if (!cell_axis)
      section.axes.push_back(new_cell_axis(section, overrides));
    else if (StudyAxis &axis = section.axes[*cell_axis]; axis.parameters.size() == 1)
      {
        for (std::size_t v = 0; v < axis.values.size(); ++v)
          if (*axis.values[v].cell < *axis.values[axis.base].cell)
            axis.base = v;
        extend(axis, section, overrides);
      }
    return section;
  }
} // namespace whipple
