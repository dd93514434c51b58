// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/hydro/closure.h>
#include <whipple/hydro/pack.h>
#include <whipple/mesh/cell_geometry.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/state/fields.h>

#include <array>
#include <vector>

namespace whipple
{
  /// What the force pass leaves for the energy pass, a pack of cells at a time; all at half step.
  template <int dim>
  struct HalfStepPack
  {
    CornerVectors<dim, Pack> volume_gradient; ///< B_k, cm^2
    CornerValues<dim, Pack>  hoop;            ///< h_k, cm^2; 0 in planar symmetry
    Pack                     volume;          ///< cm^3
    Pack                     viscosity;       ///< scalar artificial viscosity q, Mbar
    std::array<Pack, dim>    hourglass_drag;  ///< hourglass force along each axis over its corner vector, g cm/us^2
    std::array<Pack, dim>    hourglass_shape; ///< sum_k (-1)^k x_k, cm: how far the cell is from a parallelogram
  };

  /// Next values of one material, and what the step knows of its models.
  template <int dim>
  struct MaterialWork
  {
    std::vector<double> half_pressure; ///< P at half step, Mbar; empty if there is one material
    std::vector<double> volume, density, energy;
    std::vector<double> void_fraction;         ///< empty without void law
    double              yielding          = 0; ///< VoidLaw::yielding(), us cm^4/g^2; finite
    double              trace_density     = 0; ///< Material::trace_density, g/cm^3
    double              reference_density = 0; ///< at which a trace beside others lies, g/cm^3
    std::vector<double> plastic_strain;        ///< empty without strength

    /// Components of the deviator as the state stores them; empty without strength.
    std::array<std::vector<double>, DeviatorStorage<dim>::size> stress;
  };

  /// All work arrays of a Lagrange step on one mesh. Results are built up here and swapped into the state at
  /// the end, so a step that fails leaves the state untouched.
  template <int dim>
  struct StepWork
  {
    /// Neighbours across the two sides of a cell along each axis: index (2 * axis + upper) * subfaces + subface; the
    /// cell itself where it sees its mirror image, n_cells (a cell at rest) where there is none.
    using Neighbours = std::array<Index, 2 * dim * FlatMesh<dim>::subfaces>;

    bool has_strength   = false; ///< any material has it
    bool has_neighbours = false; ///< any cell has one (fragments have none)

    std::array<std::vector<double>, dim> half_position; ///< [n_nodes]
    std::array<std::vector<double>, dim> position;      ///< [n_nodes] next
    std::array<std::vector<double>, dim> velocity;      ///< [n_nodes] next
    std::array<std::vector<double>, dim> mean_velocity; ///< [n_nodes] (v^n + v^{n+1}) / 2
    std::array<std::vector<double>, dim> node_force;    ///< [n_nodes] Mbar cm^2

    std::array<std::vector<double>, dim> stretch_rate; ///< [n_cells + 1] along the logical axes, 1/us
    std::vector<Neighbours>              neighbours;   ///< [n_cells]; empty if no cell has any
    std::vector<double>                  mass;         ///< [n_cells] all materials, g; 0 where all are traces
    std::vector<double>                  corner_force; ///< [(n_cells * corners + k) * dim + axis] Mbar cm^2
    std::vector<double>                  volume;       ///< [n_cells] next
    std::vector<HalfStepPack<dim>>       half_step;    ///< [pack_count(n_cells)]

    /// [pack_count(n_cells)] forces of the artificial viscosity on the corners, Mbar cm^2; empty where it is scalar
    std::vector<CornerVectors<dim, Pack>> viscous_force;
    std::vector<MaterialWork<dim>>        material;

    std::vector<closure::Part> mixed_part;   ///< materials of the mixed cell at hand
    std::vector<double>        mixed_volume; ///< and their next volumes
  };

  /// Values of a nodal vector field at the corners of the cells of a pack.
  template <int dim, typename NodalField>
  inline CornerVectors<dim, Pack>
  gather_corners(const FlatMesh<dim> &mesh, const NodalField &field, Index first)
  {
    constexpr int            corners = FlatMesh<dim>::corners;
    const Index              last    = mesh.n_cells - 1;
    CornerVectors<dim, Pack> value;
    for (int k = 0; k < corners; ++k)
      for (int d = 0; d < dim; ++d)
        value[d][k] = Pack([&](auto lane) {
          return field[d][mesh.cell_node[std::min<Index>(first + static_cast<Index>(lane), last) * corners + k]];
        });
    return value;
  }
} // namespace whipple
