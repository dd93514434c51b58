// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/registry.h>
#include <whipple/section_entry.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// What lets material do with coarser cells than the finest. Each criterion is a class that registers itself, in a file
/// of its own (doc/extending.md); where several are on, the one that gives up most counts.
namespace whipple
{
  /// What a criterion sees: the cells of one rank, one valid layer of halo included.
  struct CellsToJudge
  {
    const FlatMesh<2>   &mesh;
    const State<2>      &state;
    const Derived       &derived; ///< of the state
    const Boundaries<2> &boundaries;
    double               finest_cell; ///< cm
    MPI_Comm             communicator;
  };

  class RefinementCriterion
  {
  public:
    virtual ~RefinementCriterion() = default;

    /// Levels below the finest that each owned cell may have, 0 for what needs the finest. Collective.
    virtual std::vector<int>
    spare_levels(const CellsToJudge &cells) const = 0;

    /// Levels that the inside of a body in one uniform state may give up.
    virtual int
    of_uniform_matter() const = 0;

    /// Entry of the scene and the field it names, if an effect has to carry that field; empty otherwise.
    virtual std::pair<std::string, std::string>
    carried_field() const
    {
      return {};
    }
  };

  /// A criterion as scenes know it.
  struct RefinementCriterionKind
  {
    std::vector<SectionEntry> entries; ///< of the section "Mesh"
    /// @returns null if it is off
    std::function<std::shared_ptr<const RefinementCriterion>(const SectionInput &input)> read;
  };

  /// All criteria there are, by name.
  class RefinementCriteria : public Registry<RefinementCriteria, RefinementCriterionKind>
  {
  };

  /// Makes a criterion known: one line at the end of its file.
  using RefinementCriterionRegistration = RefinementCriteria::Registered;

  /// Levels that a cell may give up if its state changes by `change` over it: as many as leave the change over the
  /// larger cell at most `allowed`.
  inline int
  levels_of_change(double change, double allowed, int most)
  {
    const double levels = std::floor(std::log2(allowed / std::max(change, 1e-300)));
    return static_cast<int>(std::clamp<double>(levels, 0, most));
  }
} // namespace whipple
