// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/diagnostics/debris_measure.h>
#include <whipple/diagnostics/phase_measure.h>
#include <whipple/diagnostics/plate_measure.h>
#include <whipple/diagnostics/shock_measure.h>
#include <whipple/output/summary.h>
#include <whipple/scene/scene.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

/// The results of a run under the names they have in summary.json (doc/results.md), and which of them a scene will
/// have before it runs.
namespace whipple
{
  /// Quantity -> value, of one place.
  using ResultTable = std::map<std::string, summary::Result>;

  /// What is reported of a plate, measured at `time` (us); all but that null if it could not be measured.
  ResultTable
  plate_results(const std::optional<PlateMeasure> &measure, double time);

  /// What is reported of the debris at `time` (us); every name starts with `prefix`. `inline_velocity`: see
  /// doc/results.md, left out if not known.
  ResultTable
  debris_results(const DebrisMeasure &measure, std::optional<double> inline_velocity, double time,
                 const std::string &prefix);
  /// Prefix of what is measured when a Lagrangian stage begins.
  inline constexpr const char *handover_prefix = "handover_";

  /// What is reported of temperature and phase at the end of every stage of a scene with the effect "melting".
  ResultTable
  phase_results(const PhaseMeasure &measure);

  /// What is reported of fragments at the end of every stage of a scene with the effect "fragment size"; null where
  /// nothing has broken.
  ResultTable
  fragment_results(std::optional<double> mean_size);

  /// What is reported of the shock of the scene's exact solution.
  ResultTable
  shock_results(const ShockMeasure &measure);
  /// The place it is reported under.
  inline constexpr const char *exact_place = "exact solution";

  /// Plates that are measured at the end of a stage: Eulerian stages measure those that have entered since the last
  /// Lagrangian stage (what that one has dropped is no longer there).
  template <int dim>
  std::vector<std::size_t>
  measured_plates(const Scene<dim> &scene, std::size_t stage);

  /// All results that the scene will have if it runs to its end, by place; only names and types count.
  template <int dim>
  std::map<std::string, ResultTable>
  expected_results(const Scene<dim> &scene);
} // namespace whipple
