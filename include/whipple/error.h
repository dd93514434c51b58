// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace whipple
{
  /// Base of everything Whipple throws.
  class Error : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// What the user gave is wrong; nothing has been computed. Exit status 2.
  /// The message is one line that names file, key, value and what is allowed.
  class InputError : public Error
  {
  public:
    InputError(const std::string &file, const std::string &key, const std::string &value, const std::string &allowed)
      : Error(file + ": " + key + " = '" + value + "': " + allowed)
    {
    }
    explicit InputError(const std::string &message)
      : Error(message)
    {
    }
  };

  /// A state that physics or the scheme cannot continue from (negative volume, not a number ...);
  /// the message carries the numbers. Exit status 3, state on disk.
  class StateError : public Error
  {
  public:
    using Error::Error;
  };

  /// A step or projection lost more of a conserved quantity than round-off allows. Exit status 3.
  class ConservationError : public StateError
  {
  public:
    using StateError::StateError;
  };
} // namespace whipple
