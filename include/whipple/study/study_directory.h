// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/output/directory_lock.h>

#include <string>

namespace whipple
{
  /// Make `directory` ready for the study of `study_file`: create it with its parents and mark it as that study's
  /// (DIR/study.txt holds the path of the study file), or go on in it if it is.
  /// @throws InputError if it exists, is not empty and belongs to another study or to none (nothing is overwritten), or
  /// if it cannot be created, or if another study is at work in it.
  /// @returns keeps others out
  DirectoryLock
  prepare_study_directory(const std::string &directory, const std::string &study_file);

  /// Directory of a point; of the n-th time it is run if it is run several times (0: the first).
  std::string
  point_directory(const std::string &directory, const std::string &label, int repeat = 0);

  /// What a point says on standard output and standard error goes here.
  std::string
  point_log(const std::string &directory, const std::string &label, int repeat = 0);
} // namespace whipple
