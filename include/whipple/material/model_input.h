// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/model_description.h>

#include <memory>
#include <string>

namespace whipple
{
  class EquationOfState;
  class ThermalModel;
  struct MaterialRequest;

  /// The constants a model is made of: those of the scene, then those its own source publishes for the library
  /// material, then those of the library, then defaults.
  class ModelInput
  {
  public:
    ModelInput(const ModelDescription &description, const MaterialRequest &request);

    /// Value of a constant.
    /// @throws InputError if nothing gives it, or if it is out of its range.
    double
    operator()(const std::string &key) const;

    /// The same, empty where nothing gives it.
    std::optional<double>
    find(const std::string &key) const;

    /// True if the scene itself gives it.
    bool
    given(const std::string &key) const;

    /// Value of a constant of quantity "text".
    /// @throws InputError if the scene does not give it.
    std::string
    text(const std::string &key) const;

    /// Models of the same material that are made already; null where there is none.
    std::shared_ptr<const EquationOfState> equation_of_state;
    std::shared_ptr<const ThermalModel>    thermal;

  private:
    const ModelConstant &
    constant(const std::string &key) const;

    const ModelDescription &description_;
    const MaterialRequest  &request_;
  };
} // namespace whipple
