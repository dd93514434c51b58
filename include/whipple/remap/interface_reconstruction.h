// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

#include <vector>

namespace whipple
{
  /// Piecewise linear interfaces in the undeformed boxes of cells (doc/theory/remap.md). Several materials lie in
  /// a cell like the skins of an onion: interface m bounds what materials 0 .. m fill together.
  template <int dim>
  class InterfaceReconstruction
  {
  public:
    explicit InterfaceReconstruction(const FlatMesh<dim> &mesh);

    /// Share of a box inside the cell that materials 0 .. m fill, by true volumes.
    /// The plane of (cell, m) is found on the first call and kept until `restart`.
    /// @param place position of the cell in the caller's list of mixed cells
    double
    filled_share(const State<dim> &state, Index place, Index cell, Index m, const Vector<dim> &box_lower,
                 const Vector<dim> &box_upper);

    /// Forget all planes; make room for so many mixed cells.
    void
    restart(Index n_mixed_cells, Index n_materials);

    /// Fraction of the cell that materials 0 .. m fill.
    static double
    cumulated_fraction(const State<dim> &state, Index cell, Index m);

    /// Gradient of the cumulated fraction from the mean fractions at the cell's corners, 1/cm.
    Vector<dim>
    fraction_gradient(const State<dim> &state, Index cell, Index m) const;

  private:
    struct Plane
    {
      Vector<dim> normal{};
      double      offset   = 0;
      double      fraction = 0;
      bool        known    = false;
      bool        flat     = false; ///< no gradient: the material is taken as spread evenly
    };

    Plane
    reconstruct(const State<dim> &state, Index cell, Index m) const;

    const FlatMesh<dim> *mesh_;
    std::vector<Index>   coarse_cell_; ///< [node] the cell whose face a hanging node halves, else none
    std::vector<Plane>   plane_;       ///< [place * n_materials + m]
    Index                n_materials_ = 0;
  };
} // namespace whipple
