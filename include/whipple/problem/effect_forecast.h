// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/effect/scene_outlook.h>
#include <whipple/problem/problem.h>

#include <string>
#include <vector>

/// Which effects matter, from the scene alone (`Effects/List = auto`). The numbers and what is made of them:
/// doc/theory/effects_auto.md.
namespace whipple
{
  /// All pairs of bodies of which one moves towards the other, highest pressure first; empty if no two bodies meet. An
  /// impact of the same two states at the same speed is solved once.
  template <int dim>
  std::vector<Encounter>
  encounters(const Problem<dim> &problem);

  /// Of the pairs of bodies in the same two states only the slowest and the fastest: every number of an encounter rises
  /// with the speed, so that no verdict needs the others. However many bodies, as many impacts as pairs of states.
  template <int dim>
  std::vector<Encounter>
  extreme_encounters(const Problem<dim> &problem);

  /// Time spent in stages whose cells are joined (all but Lagrangian ones of fragments), us: stages that wait for the
  /// leading edge count the way at the speed of the fastest body.
  template <int dim>
  double
  joined_duration(const Scene<dim> &scene);

  /// For every effect there is: number, verdict and reason. Needs materials (complete), bodies, stages and lattice.
  template <int dim>
  std::vector<EffectVerdict>
  forecast_effects(const Problem<dim> &problem);

  /// A verdict as a row of a table to read, without line end.
  std::string
  effect_line(const EffectVerdict &verdict);
} // namespace whipple
