// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/initial/painted_bodies.h>
#include <whipple/scene/body_volume.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace whipple
{
  namespace
  {
    /// Part of a body's volume that cuts may miss: far above the round-off of positions, far below a cell.
    constexpr double cut_tolerance = 1e-9;
    /// Part of what bodies bring that may be left out as slivers.
    constexpr double sliver_tolerance = 1e-6;

    template <int dim>
    double
    whole_volume(const Scene<dim> &scene, const Body<dim> &body)
    {
      return body_volume<dim>(scene.lattice.symmetry, body.shape, scene.lattice.origin, scene.upper_corner());
    }
  } // namespace

  template <int dim>
  PaintedBodies<dim>::PaintedBodies(const Scene<dim> &scene, std::span<const std::size_t> bodies)
    : scene_(scene)
    , bodies_(bodies)
    , received_(2 * bodies.size())
  {
  }

  template <int dim>
  void
  PaintedBodies<dim>::check(MPI_Comm communicator)
  {
    ExactSum::reduce(received_, communicator);
    if (scene_.mesh_map != MeshMap::identity)
      return;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      {
        const Body<dim> &body     = scene_.bodies[bodies_[b]];
        const double     volume   = whole_volume(scene_, body);
        const double     received = received_[2 * b].value(), rounded = received_[2 * b + 1].value();
        const bool       complete = std::abs(received + rounded - volume) <= cut_tolerance * volume;
        if (complete && rounded <= sliver_tolerance * volume)
          continue;
        std::ostringstream text;
        text.precision(12);
        text << "body '" << body.name << "' has a volume of " << volume << " cm^3; cells received " << received
             << " cm^3, and " << rounded << " cm^3 lie in cells that hold too little of it";
        throw ConservationError(text.str());
      }
  }

  template <int dim>
  void
  check_entered(const Scene<dim> &scene, std::span<const std::size_t> bodies, const ConservedTotals<dim> &entered)
  {
    if (scene.mesh_map != MeshMap::identity)
      return;
    constexpr int axis = flight_axis<dim>;
    double        mass = 0, momentum = 0, momentum_scale = 0, energy = 0, energy_scale = 0;
    for (const std::size_t b : bodies)
      {
        const Body<dim> &body = scene.bodies[b];
        if (!body.is_uniform())
          return;
        const double m      = body.density * whole_volume(scene, body);
        double       square = 0;
        for (const double v : body.velocity)
          square += v * v;
        const double deposit = body.deposit ? body.deposit->energy : 0.;
        mass += m;
        momentum += m * body.velocity[axis];
        momentum_scale += m * std::sqrt(square);
        energy += m * (body.energy + 0.5 * square) + deposit;
        energy_scale += m * (std::abs(body.energy) + 0.5 * square) + deposit;
      }
    const auto judge = [&](const char *quantity, const char *unit, double brought, double found, double scale) {
      if (std::abs(found - brought) <= sliver_tolerance * scale)
        return;
      std::ostringstream text;
      text.precision(12);
      text << "bodies that enter bring " << quantity << " of " << brought << ' ' << unit << ", but " << found << ' '
           << unit << " have come into the cells";
      throw ConservationError(text.str());
    };
    judge("a mass", "g", mass, entered.mass, mass);
    judge("an axial momentum", "g cm/us", momentum, entered.momentum[axis], momentum_scale);
    judge("an energy", "Mbar cm^3", energy, entered.total_energy(), energy_scale);
  }

  template class PaintedBodies<2>;
  template void
  check_entered(const Scene<2> &, std::span<const std::size_t>, const ConservedTotals<2> &);
} // namespace whipple
