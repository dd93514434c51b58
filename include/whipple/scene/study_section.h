// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/scene/prm_statements.h>

#include <optional>
#include <string>
#include <vector>

/// The section `Study` of a .prm: a scene and the axes along which it is varied. Its format is in doc/studies.md.
namespace whipple
{
  /// The parameter that makes an axis the cell axis.
  inline constexpr const char *cell_parameter = "Mesh/Finest cell";
  /// The name that stands for the number of MPI ranks, which is no parameter of a scene.
  inline constexpr const char *ranks_parameter = "ranks";

  /// One value of an axis.
  struct StudyValue
  {
    std::string              label; ///< for tables, plots and directories
    std::vector<std::string> parts; ///< one for each parameter of the axis
    std::optional<double>    cell;  ///< cm, of the cell axis
  };

  /// What is varied together.
  struct StudyAxis
  {
    std::string              name;
    std::vector<std::string> parameters; ///< "Section/Key", or ranks_parameter
    std::vector<StudyValue>  values;     ///< at least one
    std::size_t              base = 0;   ///< the value others are compared with
    std::string              origin;     ///< "FILE:LINE" of the values

    bool
    is_cell_axis() const
    {
      return values.front().cell.has_value();
    }
    /// Position of a label. @throws InputError naming `origin`, `key` and the labels there are.
    std::size_t
    index_of(const std::string &label, const std::string &origin, const std::string &key) const;
  };

  enum class Combination
  {
    product,      ///< every value with every other
    one_at_a_time ///< each axis alone, the others at their base
  };

  /// A label for some of the axes: (axis, value).
  using StudyChoice = std::vector<std::pair<std::size_t, std::size_t>>;

  /// What a section Study says.
  struct StudySection
  {
    std::string               scene_file; ///< the .prm that is the scene
    std::vector<PrmStatement> overrides;  ///< set in every run
    std::vector<StudyAxis>    axes;
    Combination               combination = Combination::product;
    std::vector<StudyChoice>  left_out; ///< points of a product that are not run
    int                       repeats = 1;
    std::vector<std::string>  results; ///< "place/quantity"; empty: all
    std::string               results_origin;

    std::optional<std::size_t>
    cell_axis() const;
  };

  /// A statement that stands in the section Study.
  bool
  belongs_to_study(const PrmStatement &statement);

  /// The section Study among the statements of a file; none if it has none.
  /// @throws InputError one line naming file and line, key, value and what is allowed. Whether the scene has the
  /// parameters of the axes is not checked here.
  std::optional<StudySection>
  read_study_section(const std::string &file, const std::vector<PrmStatement> &statements);
} // namespace whipple
