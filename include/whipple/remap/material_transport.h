// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/mesh/boundary.h>
#include <whipple/mesh/flat_mesh.h>
#include <whipple/remap/remap_parameters.h>
#include <whipple/remap/remap_sums.h>
#include <whipple/remap/sweep_topology.h>
#include <whipple/remap/volume_flux.h>
#include <whipple/state/fields.h>

#include <span>
#include <vector>

namespace whipple
{
  /// Carries what one material holds along with its volume fluxes: density, energy, phi and fields, by mass or by
  /// volume. Reconstruction is linear in the volume or mass coordinate of the donor, limited so that face values stay
  /// between neighbours and what remains stays in range; updates are by increments.
  template <int dim>
  class MaterialTransport
  {
  public:
    MaterialTransport(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries, const RemapParameters &parameters);

    /// Move material m through the faces of one axis; adds its mass fluxes (along + axis) to `mass_flux`.
    /// @param odd_fields places in MaterialState::fields of those that a mirror across the axis of the sweep turns
    /// round (FieldIndex::odd_at); -1 stands for none
    void
    move(MaterialState &material, Index m, const VolumeFlux<dim> &volume_flux, const SweepTopology<dim> &topology,
         std::span<const int> odd_fields, std::vector<double> &mass_flux, RemapSums<dim> &report);

  private:
    /// A face that material passes, its donor, and the cells upstream and downstream of the donor that the slope
    /// is taken from (the donor itself where there is no slope).
    struct ActiveFace
    {
      Index  face, donor;
      Index  upstream[2], downstream[2];
      double weight_up, weight_down; ///< of the central difference
      double volume_kept, mass_kept; ///< 1 - share of the donor's volume or mass behind the face that leaves
    };

    void
    collect_faces(const MaterialState &material, Index m, const VolumeFlux<dim> &volume_flux,
                  const SweepTopology<dim> &topology);
    void
    collect_cells(const MaterialState &material, const std::vector<double> &flux, const std::vector<Index> &emptied,
                  const SweepTopology<dim> &topology);
    void
    update_amounts(MaterialState &material, const std::vector<double> &flux, const SweepTopology<dim> &topology);
    void
    face_values(const std::vector<double> &value, double ActiveFace::*kept);

    /// Face values again where the donor lies at a symmetry plane across the axis, for a field that is odd there: it is
    /// straight through the plane, while even ones are extreme and have no slope.
    void
    odd_face_values(const std::vector<double> &value, double ActiveFace::*kept, int axis);
    void
    carry(std::vector<double> &value, const std::vector<double> &flux, const std::vector<double> &inverse,
          const SweepTopology<dim> &topology);
    void
    book_boundaries(const SweepTopology<dim> &topology, RemapSums<dim> &report) const;

    const FlatMesh<dim>      *mesh_;
    const RemapParameters     parameters_;
    std::vector<std::uint8_t> at_plane_; ///< [cell] symmetry planes it touches, bit 2 * axis + {0 lower, 1 upper}
    std::vector<ActiveFace>   active_;
    std::vector<Index>        kept_cells_;                    ///< keep some of what they held
    std::vector<Index>        refilled_cells_;                ///< held nothing, or gave all away, and receive something
    std::vector<Index>        cleared_cells_;                 ///< gave all away
    std::vector<std::uint8_t> is_emptied_;                    ///< [cell]
    std::vector<double>       face_value_;                    ///< [face + 1]
    std::vector<double>       mass_flux_;                     ///< [face + 1] of this material
    std::vector<double>       inverse_volume_, inverse_mass_; ///< [cell] after the sweep
  };
} // namespace whipple
