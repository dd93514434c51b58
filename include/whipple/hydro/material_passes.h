// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/step_work.h>
#include <whipple/material/material.h>
#include <whipple/state/derived.h>

#include <vector>

/// What the Lagrange step asks of the materials' models, each a batch over all cells. A model that is not there costs
/// nothing; doc/theory/lagrange_step.md.
namespace whipple::material_passes
{
  /// Arrays that the passes of one mesh share.
  struct Scratch
  {
    std::vector<double> true_density;   ///< gamma handed to the models, g/cm^3
    std::vector<double> solid_pressure; ///< P_s, Mbar; empty unless a strength model asks for it
    std::vector<double> soundness;      ///< share of the spall strength that is left; empty unless something lowers it
    std::vector<double> melt_fraction;  ///< empty unless a material melts
  };

  Scratch
  make_scratch(const std::vector<Material> &materials, Index n_cells);

  /// Bulk pressure (1 - phi) P_s(gamma, e), Mbar, and frozen sound speed, cm/us, of every material in every cell (0
  /// where there is none, or a trace). Where the equation of state gives c^2 < 0 the speed is 0.
  template <int dim>
  void
  evaluate_pressure(const std::vector<Material> &materials, const State<dim> &state, Scratch &scratch,
                    Derived &derived);

  /// Shear modulus and yield stress of every material with strength; the yield stress of damaged material is scaled
  /// with what damage leaves. In: derived.pressure and, where a model asks for it, derived.strain_rate of the same
  /// state.
  /// @throws StateError if the state lacks the fields of strength.
  template <int dim>
  void
  evaluate_strength(const std::vector<Material> &materials, const State<dim> &state, Scratch &scratch,
                    Derived &derived);

  /// Next void fractions from next densities and energies of every material with a void law. What is damaged or molten
  /// opens under less tension: the spall strength is scaled with (1 - D) (1 - melt fraction).
  template <int dim>
  void
  advance_voids(const std::vector<Material> &materials, const State<dim> &state, double dt, Scratch &scratch,
                StepWork<dim> &work);

  /// Whether every law can go on from the next densities and void fractions.
  /// @throws StateError naming material, place, densities and law if an owned cell would reach the law's pole.
  template <int dim>
  void
  check_densities(const FlatMesh<dim> &mesh, const std::vector<Material> &materials, const State<dim> &state,
                  const StepWork<dim> &work);
} // namespace whipple::material_passes
