// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/remap/interface_reconstruction.h>
#include <whipple/remap/remap_parameters.h>
#include <whipple/remap/remap_sums.h>
#include <whipple/remap/sweep_topology.h>
#include <whipple/state/fields.h>

#include <vector>

namespace whipple
{
  /// How much volume of every material passes every face in one sweep. Full cells give the swept volume itself;
  /// from cells with an interface the donor box is cut by the reconstructed planes.
  template <int dim>
  class VolumeFlux
  {
  public:
    VolumeFlux(const FlatMesh<dim> &mesh, const RemapParameters &parameters);

    /// Fill the arrays below for one axis; `swept` is what the lower cell of each face gains. Counts what nearly empty
    /// donors give away.
    /// @throws StateError where an owned donor would give more than it holds or material would leave the active
    ///   region inside the domain.
    void
    compute(const State<dim> &state, const SweepTopology<dim> &topology, const std::vector<double> &swept,
            RemapSums<dim> &report);

    /// [material][face] volume that passes along + axis, cm^3; 0 at index n_faces.
    std::vector<std::vector<double>> flux;

    /// [material] cells that give away all they hold of it.
    std::vector<std::vector<Index>> emptied;

    /// [cell] whether the cell is full of one single material.
    bool
    is_full(const Index cell) const
    {
      return content_[cell] <= first_full;
    }

  private:
    /// content_: an empty cell, a cell full of material first_full - content, or the place in the list of mixed cells.
    static constexpr Index empty = -1, first_full = -2;

    void
    classify(const State<dim> &state);
    void
    cut_donor_boxes(const State<dim> &state, const SweepTopology<dim> &topology, const std::vector<double> &swept);
    void
    check_ends(const SweepTopology<dim> &topology) const;
    void
    limit_donors(const State<dim> &state, const SweepTopology<dim> &topology, RemapSums<dim> &report);

    const FlatMesh<dim>         *mesh_;
    const RemapParameters        parameters_;
    InterfaceReconstruction<dim> reconstruction_;
    std::vector<Index>           content_;
    std::vector<Index>           mixed_cells_;
    std::vector<Index>           mixed_faces_;
  };
} // namespace whipple
