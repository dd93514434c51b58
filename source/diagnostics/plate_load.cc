// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/plate_load.h>
#include <whipple/hydro/deviator.h>
#include <whipple/mesh/gather.h>
#include <whipple/projection/cell_totals.h>
#include <whipple/scene/plate_shape.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace whipple
{
  namespace
  {
    constexpr int axial      = flight_axis<2>;
    constexpr int load_bins  = 64;
    constexpr int cells_away = 4; ///< finest cells from the plane to the plate

    /// Amounts of a cell that are spread over the bins its width covers.
    struct Share
    {
      double from, to, place; ///< cm along axis 0, and of its lower edge along axis 1
      double mass, momentum, energy;
    };

    /// Shares in the bins, added up as they come.
    PlateLoad
    in_bins(const LoadSite &site, const std::vector<Share> &all)
    {
      PlateLoad load(site.n_bins());
      for (const Share &s : all)
        {
          const auto above = std::upper_bound(site.edges.begin() + 1, site.edges.end() - 1, s.from);
          for (std::size_t b = above - site.edges.begin() - 1; b < site.n_bins() && site.edges[b] < s.to; ++b)
            {
              const double low  = std::max(s.from, site.edges[b]);
              const double high = b + 1 == site.n_bins() ? s.to : std::min(s.to, site.edges[b + 1]);
              const double part = site.area(low, high) / site.area(s.from, s.to);
              load.mass[b] += part * s.mass;
              load.momentum[b] += part * s.momentum;
              load.energy[b] += part * s.energy;
            }
        }
      return load;
    }

    /// The shares of all ranks in the bins, added up in the order of their places.
    PlateLoad
    spread(const LoadSite &site, const std::vector<Share> &mine, MPI_Comm communicator)
    {
      std::vector<Share> all = gather_all(communicator, std::span<const Share>(mine)).entry;
      std::sort(all.begin(), all.end(),
                [](const Share &a, const Share &b) { return std::tie(a.from, a.place) < std::tie(b.from, b.place); });
      return in_bins(site, all);
    }

    /// Where a part that waits is.
    struct Place
    {
      double from, to, middle; ///< cm along axis 0, and along axis 1
    };

    Place
    place_of(const LoadSite &site, const CellPacketLayout<2> &layout, const Waiting<2> &part, double time)
    {
      const CornerVectors<2> x = corners_at(site.symmetry, layout, part, time);
      Place                  place{0., 0., 0.};
      for (int k = 0; k < 4; ++k)
        {
          const double r = site.symmetry == Symmetry::axisymmetric ? std::abs(x[0][k]) : x[0][k];
          place.from     = k == 0 ? r : std::min(place.from, r);
          place.to       = k == 0 ? r : std::max(place.to, r);
          place.middle += 0.25 * x[axial][k];
        }
      return place;
    }

    /// Stress of a cell on a plane normal to axis 1, by volume of its materials, Mbar.
    struct Traction
    {
      double normal = 0, tangential = 0; ///< zz, tension positive, and rz
    };

    template <int dim>
    Traction
    traction(const State<dim> &state, const Derived &derived, Index c)
    {
      Traction t;
      for (std::size_t i = 0; i < state.material.size(); ++i)
        {
          const MaterialState &m     = state.material[i];
          const double         share = m.volume[c] / state.volume[c];
          t.normal -= share * derived.material[i].pressure[c];
          if (!state.index.has_stress())
            continue;
          const double solid = m.has_voids() ? 1. - m.void_fraction[c] : 1.;
          const auto   s     = StoredDeviator<dim>(m, state.index).at(c);
          t.normal += share * solid * s.normal(flight_axis<dim>);
          t.tangential += share * solid * s.shear();
        }
      return t;
    }
  } // namespace

  double
  LoadSite::area(double from, double to) const
  {
    return symmetry == Symmetry::axisymmetric ? std::numbers::pi * (to - from) * (to + from) : to - from;
  }

  PlateLoad::PlateLoad(std::span<const double> numbers)
    : PlateLoad(numbers.size() / 3)
  {
    const std::size_t n = mass.size();
    std::copy_n(numbers.begin(), n, mass.begin());
    std::copy_n(numbers.begin() + n, n, momentum.begin());
    std::copy_n(numbers.begin() + 2 * n, n, energy.begin());
  }

  std::vector<double>
  PlateLoad::numbers() const
  {
    std::vector<double> all = mass;
    all.insert(all.end(), momentum.begin(), momentum.end());
    all.insert(all.end(), energy.begin(), energy.end());
    return all;
  }

  PlateLoad &
  PlateLoad::operator+=(const PlateLoad &other)
  {
    for (std::size_t b = 0; b < mass.size(); ++b)
      {
        mass[b] += other.mass[b];
        momentum[b] += other.momentum[b];
        energy[b] += other.energy[b];
      }
    return *this;
  }

  template <int dim>
  LoadSite
  load_site(const Scene<dim> &scene, std::size_t plate)
  {
    LoadSite site{scene.lattice.symmetry, 0., scene.bodies[plate].shape.template as<Plate<dim>>()->front, {}};
    site.plane        = site.face - cells_away * scene.lattice.spacing;
    const double left = scene.lattice.origin[0], right = scene.upper_corner()[0];
    for (int i = 0; i <= load_bins; ++i)
      site.edges.push_back(left + (right - left) * i / load_bins);
    return site;
  }

  template <int dim>
  std::optional<std::size_t>
  loaded_plate(const Scene<dim> &scene)
  {
    std::optional<std::size_t> last;
    double                     farthest = scene.lattice.origin[axial];
    for (const Stage &stage : scene.stages)
      if (stage.mode() == StageMode::eulerian)
        for (const std::size_t body : stage.introduces)
          if (scene.bodies[body].shape.template as<Plate<dim>>())
            if (const LoadSite site = load_site(scene, body); site.plane > farthest)
              {
                farthest = site.plane;
                last     = body;
              }
    return last;
  }

  template <int dim>
  PlateLoad
  load_of_step(const LoadSite &site, const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
               double dt, MPI_Comm communicator)
  {
    const auto cut = [&](Index c) {
      return mesh.lower[axial][c] <= site.plane && site.plane < mesh.lower[axial][c] + mesh.size[c];
    };
    std::vector<Share>                         mine;
    std::optional<const CornerVelocities<dim>> velocities;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        if (!cut(c) || !(cell_mass(state, c) > 0))
          continue;
        if (!velocities)
          velocities.emplace(corner_velocities(mesh, state));
        const ConservedTotals<dim> cell = cell_totals<dim>(state, *velocities, c);
        const Traction             t    = traction(state, derived, c);
        const double               from = mesh.lower[0][c], to = from + mesh.size[c];
        const double               across = cell.momentum[0] / cell.mass, along = cell.momentum[axial] / cell.mass;
        const double               area = site.area(from, to), flow = along * area * dt; // cm^3 that pass
        mine.push_back(
            {from, to, mesh.lower[axial][c], cell.mass / state.volume[c] * flow,
             cell.momentum[axial] / state.volume[c] * flow - t.normal * area * dt,
             cell.total_energy() / state.volume[c] * flow - (t.normal * along + t.tangential * across) * area * dt});
      }
    return spread(site, mine, communicator);
  }

  PlateLoad
  load_of_waiting(const LoadSite &site, const CellPacketLayout<2> &layout, const WaitingDebris<2> &waiting,
                  double before, double now)
  {
    std::vector<Share> passed;
    for (const Waiting<2> &part : waiting.parts)
      {
        const Place place = place_of(site, layout, part, now);
        if (place.middle < site.plane || !(place_of(site, layout, part, before).middle < site.plane))
          continue;
        const ConservedTotals<2> totals = totals_of(layout, part.element);
        passed.push_back(
            {place.from, place.to, place.middle, totals.mass, totals.momentum[axial], totals.total_energy()});
      }
    return in_bins(site, passed);
  }

  template <int dim>
  PlateLoad
  load_past_plane(const LoadSite &site, const FlatMesh<dim> &mesh, const State<dim> &state, MPI_Comm communicator)
  {
    const CornerVelocities<dim> velocities = corner_velocities(mesh, state);
    std::vector<Share>          mine;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        const double lower = mesh.lower[axial][c], upper = lower + mesh.size[c];
        if (0.5 * (lower + upper) < site.plane || upper > site.face + 1e-6 * mesh.size[c])
          continue;
        const ConservedTotals<dim> cell = cell_totals<dim>(state, velocities, c);
        if (cell.mass > 0)
          mine.push_back({mesh.lower[0][c], mesh.lower[0][c] + mesh.size[c], mesh.lower[axial][c], cell.mass,
                          cell.momentum[axial], cell.total_energy()});
      }
    return spread(site, mine, communicator);
  }

  template std::optional<std::size_t>
  loaded_plate(const Scene<2> &);
  template LoadSite
  load_site(const Scene<2> &, std::size_t);
  template PlateLoad
  load_of_step(const LoadSite &, const FlatMesh<2> &, const State<2> &, const Derived &, double, MPI_Comm);
  template PlateLoad
  load_past_plane(const LoadSite &, const FlatMesh<2> &, const State<2> &, MPI_Comm);
} // namespace whipple
