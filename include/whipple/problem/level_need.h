// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/problem/field_layout.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <vector>

namespace whipple
{
  /// How fine a mesh the contents of a scene need; MeshControl holds the criteria.
  /// Equations: doc/theory/refinement.md, "Which level where".
  template <int dim>
  class LevelNeed
  {
  public:
    LevelNeed(const Scene<dim> &scene, const FieldLayout &layout);

    /// Level that material of a solid fraction s = sum V_m (1 - phi_m) / sum V_m needs: the finest if it is dense,
    /// whatever part of the cell it fills, one level less below MeshControl::solid_fraction, one more for each factor
    /// solid_ratio.
    int
    of_solid_fraction(double solid_fraction) const;

    /// Level for a body that is about to enter: the finest, or fewer levels if it is at rest and free of stress.
    int
    of_body(const Body<dim> &body) const;

    /// The same for what lies well inside such a body: its state is uniform, unless it comes from an exact solution.
    int
    inside_body(const Body<dim> &body) const;

    /// Level that each owned cell needs, -1 without material. Collective: what counts as smooth is measured against
    /// the largest values of all ranks.
    std::vector<int>
    of_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived, MPI_Comm communicator) const;

    /// Level of a leaf where the contents have no say: Refinement::uniform and Refinement::region.
    std::uint8_t
    fixed(CellKey leaf) const;

  private:
    /// Whether nothing has reached a cell yet: solid without pores, at rest and free of stress. Its state is uniform
    /// and its interface plane, so coarse cells hold it as well as fine ones.
    bool
    is_quiet(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived, Index cell) const;

    const Scene<dim>  &scene_;
    const FieldLayout &layout_;
    int                quiet_levels_; ///< that undisturbed material gives up
  };
} // namespace whipple
