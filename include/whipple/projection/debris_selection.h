// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/conserved_totals.h>
#include <whipple/state/fields.h>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace whipple
{
  /// Which cells of an Eulerian stage become elements of the Lagrangian one.
  struct DebrisCriteria
  {
    double                void_cutoff = 0.99; ///< drop cells whose void 1 - sum_m (1-phi_m) f_m is above it
    double                direction   = 1;    ///< +1 or -1: the way the debris flies along the last axis
    std::optional<double> plane;              ///< drop cells whose centre lies behind it, cm along the last axis
    std::optional<double> least_velocity;     ///< drop cells slower than it towards `direction`, cm/us
  };

  /// What became of a cell.
  enum class Verdict : std::uint8_t
  {
    empty,       ///< no material: neither kept nor dropped
    kept,        ///< becomes an element
    void_cutoff, ///< too thin
    not_debris   ///< behind the plane or too slow
  };
  inline constexpr int n_verdicts = 4;

  /// Name of a verdict as the ledger prints it.
  constexpr std::string_view
  name(Verdict verdict)
  {
    constexpr std::array<std::string_view, n_verdicts> names{{"empty", "kept", "void cutoff", "not debris"}};
    return names[static_cast<int>(verdict)];
  }

  /// Verdicts on this rank's owned cells and what they amount to.
  template <int dim>
  struct DebrisSelection
  {
    std::vector<Verdict>                         verdict; ///< [n_owned]
    std::array<ConservedTotals<dim>, n_verdicts> amount;  ///< by verdict; kinetic energy by corner masses

    bool
    kept(Index cell) const
    {
      return verdict[cell] == Verdict::kept;
    }
    const ConservedTotals<dim> &
    amount_of(Verdict v) const
    {
      return amount[static_cast<int>(v)];
    }
  };

  /// Judge all owned cells. "Not debris" is judged before the void cutoff. A cell's velocity is that of its
  /// corners weighted with their masses. The amounts of all verdicts add up to the totals of the state.
  template <int dim>
  DebrisSelection<dim>
  select_debris(const FlatMesh<dim> &mesh, const State<dim> &state, const DebrisCriteria &criteria);
} // namespace whipple
