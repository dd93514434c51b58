// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <vector>

namespace whipple
{
  /// What the models of one material make of its state, in the cells of one rank (halo included); one value a cell.
  struct DerivedMaterial
  {
    std::vector<double> pressure;      ///< bulk P = (1 - phi) P_s(gamma, e), Mbar; 0 where there is none, or a trace
    std::vector<double> sound_speed;   ///< frozen (phi fixed) bulk sound speed, cm/us; 0 likewise
    std::vector<double> shear_modulus; ///< G of the solid, Mbar; empty without strength
    std::vector<double> yield_stress;  ///< Y of the solid, scaled with what damage leaves, Mbar; empty without strength
  };

  /// What follows from a State and is no part of it: LagrangeStep::evaluate() fills it, a step takes it as an argument.
  /// It is that of one state: after any change of the state it is evaluated anew. It is neither carried to another mesh
  /// nor kept for going back. Equations: doc/theory/lagrange_step.md, "What is carried and what follows".
  struct Derived
  {
    std::vector<DerivedMaterial> material;
    std::vector<double>          strain_rate; ///< [n_cells] equivalent rate sqrt(2/3 D':D') of the deviatoric motion,
                                              ///< 1/us; empty unless a strength model asks for it
  };
} // namespace whipple
