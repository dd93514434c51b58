// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What users write, read from arbitrary bytes: by libFuzzer (doc/fuzzing.md) and, for the corpus, by the unit tests.
/// Every target returns the message of the InputError that the bytes are refused with, empty if they are accepted. Any
/// other exception, a message of several lines, and a value that breaks a promise (std::logic_error) is a fault.
namespace whipple::fuzz
{
  /// A scene file.
  std::string
  scene(std::string_view bytes);

  /// Statements of `--set`, one a line, over a small scene.
  std::string
  override(std::string_view bytes);

  /// First byte: which quantity; then a number with its unit. What is accepted is finite and reads back to the same
  /// bits.
  std::string
  units(std::string_view bytes);

  /// An HDF5 file of a table. The law of an accepted one is finite at every density and energy.
  std::string
  table_file(std::string_view bytes);

  /// A small good table, first byte: which of its axes the second is; then edits of 10 bytes: dataset, element, value.
  std::string
  table_fields(std::string_view bytes);

  struct Target
  {
    const char *name; ///< and folder of its corpus
    std::string (*run)(std::string_view bytes);
  };
  inline const std::vector<Target> targets{{"scene", scene},
                                           {"override", override},
                                           {"units", units},
                                           {"table_file", table_file},
                                           {"table_fields", table_fields}};
} // namespace whipple::fuzz
