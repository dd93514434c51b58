// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/study/study_plan.h>

#include <ostream>

namespace whipple
{
  /// Run a study: every point as a process of its own, then study.csv, study.md and study.json in its directory. With
  /// options.tolerance only what is needed to reach that. Call on one process, before MPI is up.
  /// @throws InputError before anything is computed or written if the study, one of its points, the tolerance, the
  /// budget or the directory is not acceptable
  /// @throws Error if no point completed
  void
  run_study(const StudyOptions &options, std::ostream &output);
} // namespace whipple
