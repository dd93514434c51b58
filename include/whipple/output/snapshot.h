// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace whipple
{
  /// One scalar a cell, ready to be written.
  struct CellField
  {
    std::string         name; ///< "pressure", "aluminium plastic strain"
    std::string         unit; ///< "Mbar"; "1" for pure numbers
    std::vector<double> value;
  };

  /// "pressure [Mbar]": how readers of files see a quantity; pure numbers have no unit.
  inline std::string
  with_unit(const std::string &name, const std::string &unit)
  {
    return unit == "1" ? name : name + " [" + unit + ']';
  }

  /// What one rank shows of its state at one time: the chosen cells, the nodes they use, renumbered from 0.
  template <int dim>
  struct Snapshot
  {
    static constexpr int corners = 1 << dim;

    /// Corners in the order in which XDMF and VTK walk around a cell, as lexicographic numbers.
    static constexpr std::array<int, corners> walk = [] {
      if constexpr (dim == 2)
        return std::array<int, corners>{{0, 1, 3, 2}};
      else
        return std::array<int, corners>{{0, 1, 3, 2, 4, 5, 7, 6}};
    }();

    double                 time = 0;  ///< us
    std::vector<double>    position;  ///< [n_nodes * dim] cm
    std::vector<double>    velocity;  ///< [n_nodes * 3] cm/us, the third component 0 in two dimensions
    std::vector<Index>     cell_node; ///< [n_cells * corners], lexicographic
    std::vector<CellField> fields;    ///< [n_cells] each; the same list on every rank

    std::size_t
    n_nodes() const
    {
      return position.size() / dim;
    }
    std::size_t
    n_cells() const
    {
      return cell_node.size() / corners;
    }
  };

  /// Nodes of the cells in the order of the walk. @param first_node number of the first of this rank's nodes
  template <int dim>
  std::vector<std::int32_t>
  walked_cells(const Snapshot<dim> &snapshot, std::uint64_t first_node);

  /// Fields of chosen cells that are functions of the state (temperature ...), for those who know the materials.
  template <int dim>
  using ExtraFields = std::function<std::vector<CellField>(const State<dim> &, const std::vector<Index> &cells)>;

  /// Which cells a snapshot shows and how much of them.
  struct SnapshotOptions
  {
    bool empty_cells = false; ///< also cells without material
    bool everything  = false; ///< also what identifies and restores a cell: lattice point, volumes, masses
    int  rank        = 0;     ///< value of the field "rank"
  };

  /// All fields of chosen cells that take_snapshot() shows, without geometry; the same list whatever the cells.
  template <int dim>
  std::vector<CellField>
  fields_of_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                  const std::vector<std::string> &material_names, const ExtraFields<dim> &extra,
                  const std::vector<Index> &cells, int rank);

  /// Collect owned cells of a state. Fields of the cell: density (mass of all materials / cell volume), pressure
  /// (volume weighted; open void counts 0), solid fraction (volume without pores and open void / cell volume),
  /// level, rank. Of each material m, named `material_names[m] + " ..."`: volume fraction, density (bulk), true
  /// density rho / (1 - phi), pressure, energy, void fraction where it has one, and every registered field; then what
  /// `extra` (may be empty) makes of the state.
  template <int dim>
  Snapshot<dim>
  take_snapshot(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                const std::vector<std::string> &material_names, const ExtraFields<dim> &extra,
                const SnapshotOptions &options);
} // namespace whipple
