// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_builder.h>

#include <cstdint>
#include <span>
#include <vector>

namespace whipple
{
  /// The level every leaf takes in one round of refinement and coarsening. A pure function of the whole forest,
  /// so every rank that calls it with the same leaves gets the same answer (doc/theory/mesh.md):
  ///
  /// * a leaf moves by at most one level towards its target;
  /// * a family coarsens only if all its siblings are leaves and want to, and no leaf that touches them is finer
  ///   now or becomes finer than them;
  /// * whatever touches a refined leaf is raised until levels differ by at most one over faces and corners.
  ///
  /// @param leaves all leaves of the forest in forest order (siblings adjacent), 2:1 balanced
  /// @param target wanted level of each leaf
  /// @returns new level of each leaf, present level -1, +0 or +1
  /// @throws StateError if a target exceeds lattice.max_level or lengths differ.
  template <int dim>
  std::vector<std::uint8_t>
  agree_levels(const Lattice<dim> &lattice, std::span<const CellKey> leaves, std::span<const std::uint8_t> target);

  /// The leaves after that round, in forest order.
  template <int dim>
  std::vector<CellKey>
  adapted_leaves(const Lattice<dim> &lattice, std::span<const CellKey> leaves, std::span<const std::uint8_t> level);
} // namespace whipple
