// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/material/material.h>

#include <optional>
#include <string>
#include <vector>

namespace whipple
{
  /// What a scene asks a material to be. Constants left out come from the library material; a request
  /// without a library material must give all that its models need. Units: cm, g, us, Mbar.
  struct MaterialRequest
  {
    std::string name;    ///< for messages and reports; empty: the library's name
    std::string library; ///< material_names(); empty: none, all constants given here

    std::string equation_of_state = "mie-grueneisen"; ///< equation_of_state_kinds()
    std::string strength          = "none";           ///< strength_kinds()
    std::string void_law          = "none";           ///< void_law_kinds()

    std::optional<double> density;            ///< gamma0 [g/cm^3]
    std::optional<double> sound_speed;        ///< c0 [cm/us]
    std::optional<double> hugoniot_slope;     ///< s
    std::optional<double> grueneisen;         ///< Gamma0
    std::optional<double> adiabatic_exponent; ///< k of the gases
    /// c1 ... c6 of the linear polynomial [Mbar, the last three without unit]; those left out are the
    /// expansion of the Mie-Grueneisen law about gamma0 (doc/theory/equation_of_state.md), or 0 if c1 is given.
    std::optional<double> c1, c2, c3, c4, c5, c6;

    std::optional<double> shear_modulus;     ///< G [Mbar]
    std::optional<double> yield_stress;      ///< Y [Mbar]
    std::optional<double> hardening_modulus; ///< H = dY/d(plastic strain) [Mbar]

    double alpha          = 1000.; ///< rate of the void law [us/cm^2], may be infinite
    double spall_strength = 0.;    ///< [Mbar], may be infinite
    bool   isothermal     = false; ///< P_s = P_s(gamma, 0)
  };

  /// One admissible value of a model selector, for messages and help texts.
  struct ModelKind
  {
    std::string name;        ///< "perfectly plastic"
    std::string description; ///< one line, with the constants the kind needs
  };

  /// "mie-grueneisen", "ideal gas", "stiffened gas", "linear polynomial".
  std::vector<ModelKind>
  equation_of_state_kinds();

  /// "none", "perfectly plastic", "linear hardening".
  std::vector<ModelKind>
  strength_kinds();

  /// "none", "rate", "equilibrium".
  std::vector<ModelKind>
  void_law_kinds();

  /// The material a request describes, ready to run.
  /// @throws InputError (one line: which constant, its value, what is allowed; no file name, the caller knows
  /// it) for an unknown name or kind, a constant that is missing, impossible, or of no use to the kinds chosen.
  Material
  make_material(const MaterialRequest &request);
} // namespace whipple
