// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <map>
#include <string>

namespace whipple
{
  /// What a scene asks a material to be: a model of each family, and constants by key. Constants left out come from the
  /// library material; a request without a library material must give all that its models need. Units: cm, g, us, Mbar.
  struct MaterialRequest
  {
    std::string name;    ///< for messages and reports; empty: the library's name
    std::string library; ///< material_names(); empty: none, all constants given here

    std::string equation_of_state = "mie-grueneisen";
    std::string strength          = "none";
    std::string void_law          = "none";
    std::string thermal_model     = "none";
    std::string failure           = "none";
    std::string fragments         = "none";
    std::string conduction        = "none";

    std::map<std::string, double>      constants; ///< by ModelConstant::key
    std::map<std::string, std::string> texts;     ///< those of quantity "text"

    bool isothermal = false; ///< P_s = P_s(gamma, 0)

    /// Value of a constant, `otherwise` if the request does not give it.
    double
    constant_or(const std::string &key, double otherwise) const
    {
      const auto found = constants.find(key);
      return found == constants.end() ? otherwise : found->second;
    }
  };
} // namespace whipple
