// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>

/// DIR/manifest.txt: what a run has written into its output directory, a name a line, so that a later run can remove
/// that and nothing else. Files are listed when they are created, so the list is true of a run that was killed, too.
/// All of it is for the first rank alone.
namespace whipple::manifest
{
  constexpr const char *file_name = "manifest.txt";

  /// List a file. @param name relative to the directory, "fields/fields-00007.h5"; with a slash at its end a folder in
  /// which everything is the run's own ("checkpoints/"). A name may be listed twice.
  /// @throws Error if the disk refuses
  void
  note(const std::string &directory, std::string_view name);

  /// Remove what the manifest lists, itself, and folders that are empty then. A folder that has a manifest of its own
  /// is cleared by that. What is not there, or would lie outside of the directory, is passed over.
  /// @throws InputError if the directory has no manifest
  void
  remove_listed(const std::string &directory);
} // namespace whipple::manifest
