// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/error.h>

#include <string>

namespace whipple
{
  /// Message of the error that some work throws; empty if it throws none. What is no such error goes on.
  template <typename Failure = InputError, typename Work>
  std::string
  complaint_of(const Work &work)
  {
    try
      {
        work();
      }
    catch (const Failure &error)
      {
        return error.what();
      }
    return "";
  }

  inline bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace whipple
