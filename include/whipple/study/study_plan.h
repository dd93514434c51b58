// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/measure.h>
#include <whipple/scene/study_section.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// What the command line asks of a study.
  struct StudyOptions
  {
    std::string              file;             ///< the .prm with the section Study, or (with a tolerance) a scene
    std::vector<std::string> overrides;        ///< "Section/Key = value", also of the section Study
    std::string              output_directory; ///< never empty: `output/<study stem>` unless given
    int                      ranks = 1;        ///< of every point that no axis `ranks` says otherwise about
    std::string              tolerance;        ///< "bumper hole diameter = 2 %"; empty: run all points
    std::string              budget;           ///< "20 min"; empty: none
    bool                     validate_only = false;
    bool                     any_version   = false; ///< also reuse points that another version has computed
    bool                     live          = false; ///< standard output is a terminal
    std::string              command;               ///< the words it was started with, for the report
  };

  /// One run of a study.
  struct StudyPoint
  {
    std::string               label;  ///< name of its directory (point_label)
    std::vector<std::size_t>  choice; ///< value of each axis
    std::vector<PrmStatement> overrides;
    int                       ranks = 1;
    double                    cell  = 0;            ///< finest cell, cm
    std::string               effective_parameters; ///< every value in force

    bool
    operator==(const StudyPoint &other) const
    {
      return choice == other.choice;
    }
  };

  /// Every run of a study, checked as scenes.
  struct StudyPlan
  {
    std::string             file, title; ///< study file; title of the scene
    StudySection            section;
    std::vector<StudyPoint> points; ///< coarse cells first
    bool                    has_exact_solution = false;

    std::map<std::string, ResultTable> results; ///< what the runs will report, by place; names and types only
  };

  /// The section Study of a file with the overrides applied; without the section (tolerance only) a study of that scene
  /// without axes.
  /// @throws InputError
  StudySection
  read_study(const StudyOptions &options);

  /// Combine the axes of a section and read every point as a scene.
  /// @throws InputError one line; names the point if a scene refuses its values.
  StudyPlan
  plan_study(const StudyOptions &options, const StudySection &section);

  /// What sets a series of points apart, for people: the labels of all axes but the cell axis, "eulerian, second
  /// order"; of a study that varies one axis at a time what is not at its base, "hand-over: 0.75 us", or "base".
  std::string
  method_name(const StudySection &section, const std::vector<std::size_t> &choice);

  /// A point for people: its cell and its method_name, "0.008 cm, eulerian, second order".
  std::string
  point_name(const StudySection &section, const std::vector<std::size_t> &choice);

  /// Name of a point's directory, "cell=0.016cm,mode=lagrangian"; of a study that varies one axis at a time only the
  /// cell and what is not at its base. Blanks go, and what does not belong into the name of a directory becomes '_'.
  std::string
  point_label(const StudySection &section, const std::vector<std::size_t> &choice);
} // namespace whipple
