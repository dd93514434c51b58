// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <whipple/projection/waiting_debris.h>
#include <whipple/scene/scene.h>
#include <whipple/state/derived.h>
#include <whipple/state/fields.h>

#include <mpi.h>

#include <optional>
#include <span>
#include <vector>

/// What debris brings to a plate, by distance from the line of flight: mass, axial momentum and energy that pass a
/// plane before it. Equations: doc/theory/measures.md, "The load on the last plate".
namespace whipple
{
  /// Where the load on a plate is taken.
  struct LoadSite
  {
    Symmetry            symmetry = Symmetry::planar;
    double              plane    = 0; ///< cm along axis 1
    double              face     = 0; ///< cm, the plate's front face as it entered
    std::vector<double> edges;        ///< of equal bins along axis 0 over the whole domain, cm

    std::size_t
    n_bins() const
    {
      return edges.size() - 1;
    }
    /// cm^2, in planar geometry of a depth of 1 cm.
    double
    area(double from, double to) const;
  };

  /// The body whose load is measured: the plate with the farthest front face of those that a fixed mesh takes in, if
  /// the plane before it is in the domain.
  template <int dim>
  std::optional<std::size_t>
  loaded_plate(const Scene<dim> &scene);

  /// @param plate a body that is a plate
  template <int dim>
  LoadSite
  load_site(const Scene<dim> &scene, std::size_t plate);

  /// Mass [g], axial momentum [g cm/us] and energy [Mbar cm^3] of every bin.
  struct PlateLoad
  {
    std::vector<double> mass, momentum, energy;

    explicit PlateLoad(std::size_t n_bins)
      : mass(n_bins, 0.)
      , momentum(n_bins, 0.)
      , energy(n_bins, 0.)
    {
    }
    /// Of the three lists, one after the other.
    explicit PlateLoad(std::span<const double> numbers);
    std::vector<double>
    numbers() const;

    PlateLoad &
    operator+=(const PlateLoad &other);
  };

  /// What passes the plane of a fixed mesh in dt [us], all ranks together. The same bits on any number of ranks.
  /// Collective.
  template <int dim>
  PlateLoad
  load_of_step(const LoadSite &site, const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
               double dt, MPI_Comm communicator);

  /// What of the debris that waits has come from before one place along axis 1 to beyond `plane` between two times
  /// [us]: each part whole when its middle passes. The same on all ranks.
  PlateLoad
  load_of_waiting(const LoadSite &site, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting,
                  double before, double now);

  /// What the cells between the plane and the plate's face hold, all ranks together: debris that is past the plane when
  /// a stage begins. Collective.
  template <int dim>
  PlateLoad
  load_past_plane(const LoadSite &site, const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator);
} // namespace whipple
