// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/debris_measure.h>
#include <whipple/mesh/collective.h>
#include <whipple/mesh/gather.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

namespace whipple
{
  namespace
  {
    struct Parcel
    {
      double mass, radius, axial, axial_velocity;
    };

    /// The value below which a share of the mass lies; parcels in ascending order of `coordinate`.
    double
    quantile(std::vector<Parcel> &parcels, double share, const std::function<double(const Parcel &)> &coordinate)
    {
      std::sort(parcels.begin(), parcels.end(), [&](const Parcel &a, const Parcel &b) {
        return std::make_tuple(coordinate(a), a.radius, a.axial) < std::make_tuple(coordinate(b), b.radius, b.axial);
      });
      double total = 0;
      for (const Parcel &p : parcels)
        total += p.mass;
      double sum = 0;
      for (const Parcel &p : parcels)
        if ((sum += p.mass) >= share * total)
          return coordinate(p);
      return coordinate(parcels.back());
    }

    template <int dim>
    std::vector<Parcel>
    parcels_of(const FlatMesh<dim> &mesh, const State<dim> &state, const std::function<bool(Index)> &belongs)
    {
      constexpr int       corners = FlatMesh<dim>::corners;
      std::vector<Parcel> parcels;
      for (Index c = 0; c < mesh.n_owned; ++c)
        {
          Parcel p{0, 0, 0, 0};
          for (const MaterialState &m : state.material)
            p.mass += m.mass[c];
          if (p.mass == 0. || !belongs(c))
            continue;
          for (int k = 0; k < corners; ++k)
            {
              const Index n = mesh.cell_node[c * corners + k];
              p.radius += state.position[0][n] / corners;
              p.axial += state.position[flight_axis<dim>][n] / corners;
              p.axial_velocity += state.corner_weight[c * corners + k] * state.velocity[flight_axis<dim>][n];
            }
          p.radius = std::abs(p.radius);
          parcels.push_back(p);
        }
      return parcels;
    }

    template <int dim>
    void
    add_waiting(Symmetry symmetry, const CellPacketLayout<dim> &layout, const WaitingDebris<dim> &waiting, double time,
                std::vector<Parcel> &parcels)
    {
      for (const Waiting<dim> &part : waiting.parts)
        {
          const CornerVectors<2>     x      = corners_at(symmetry, layout, part, time);
          const ConservedTotals<dim> totals = totals_of(layout, part.element);
          Parcel                     p{totals.mass, 0., 0., totals.momentum[1] / totals.mass};
          for (int k = 0; k < 4; ++k)
            {
              p.radius += 0.25 * x[0][k];
              p.axial += 0.25 * x[1][k];
            }
          p.radius = std::abs(p.radius);
          parcels.push_back(p);
        }
    }
  } // namespace

  template <int dim>
  DebrisMeasure
  measure_debris(const FlatMesh<dim> &mesh, const State<dim> &state, const std::function<bool(Index)> &belongs,
                 double origin, MPI_Comm communicator, const WaitingDebris<dim> *waiting)
  {
    const std::vector<Parcel> mine    = parcels_of(mesh, state, belongs);
    std::vector<Parcel>       parcels = gather_all(communicator, std::span<const Parcel>(mine)).entry;
    if (waiting)
      add_waiting(mesh.symmetry, CellPacketLayout<dim>::of(state), *waiting, state.time, parcels);
    DebrisMeasure result;
    if (parcels.empty())
      return result;
    const auto axial  = [](const Parcel &p) { return p.axial; };
    const auto radial = [](const Parcel &p) { return p.radius; };

    result.radius       = quantile(parcels, 0.99, radial);
    result.radius_95    = quantile(parcels, 0.95, radial);
    result.depth_95     = quantile(parcels, 0.95, axial) - origin;
    result.leading_edge = quantile(parcels, 0.999, axial);
    result.length       = result.leading_edge - quantile(parcels, 0.001, axial);
    result.cone_angle   = 2. * std::atan2(result.radius_95, result.leading_edge - origin) * 180. / std::numbers::pi;
    for (const Parcel &p : parcels)
      {
        result.mass += p.mass;
        result.axial_momentum += p.mass * p.axial_velocity;
      }
    result.mass_velocity = result.axial_momentum / result.mass;

    // parcels are in axial order now: the foremost 1 % of the mass
    double front_mass = 0, front_momentum = 0;
    for (auto p = parcels.rbegin(); p != parcels.rend() && front_mass < 0.01 * result.mass; ++p)
      {
        front_mass += p->mass;
        front_momentum += p->mass * p->axial_velocity;
      }
    result.leading_edge_velocity = front_momentum / front_mass;
    return result;
  }

  template <int dim>
  double
  foremost_point(const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator)
  {
    constexpr int corners  = FlatMesh<dim>::corners;
    double        foremost = -std::numeric_limits<double>::max();
    for (Index c = 0; c < mesh.n_owned; ++c)
      for (const MaterialState &m : state.material)
        if (m.mass[c] > 0)
          for (int k = 0; k < corners; ++k)
            foremost = std::max(foremost, state.position[flight_axis<dim>][mesh.cell_node[c * corners + k]]);
    return max_over_ranks(foremost, communicator);
  }

  template DebrisMeasure
  measure_debris(const FlatMesh<2> &, const State<2> &, const std::function<bool(Index)> &, double, MPI_Comm,
                 const WaitingDebris<2> *);
  template double
  foremost_point(const FlatMesh<2> &, const State<2> &, MPI_Comm);
} // namespace whipple
