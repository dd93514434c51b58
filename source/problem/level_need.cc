// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/mesh/key_arithmetic.h>
#include <whipple/problem/level_need.h>
#include <whipple/refinement/refinement_criterion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// Levels that undisturbed material may give up: the thinnest body must keep `least_cells` cells, or cells with
    /// void on both sides would not know where in them the material is.
    template <int dim>
    int
    quiet_levels(const Scene<dim> &scene)
    {
      constexpr double least_cells = 2.5;
      double           thinnest    = std::numeric_limits<double>::infinity();
      for (const Body<dim> &body : scene.bodies)
        {
          const Box<dim> box = extent(body.shape);
          for (int d = 0; d < dim; ++d)
            thinnest = std::min(thinnest, box.upper[d] - box.lower[d]);
          thinnest = std::min(thinnest, body.shape->least_thickness({}));
        }
      const double levels = std::floor(std::log2(thinnest / (least_cells * scene.lattice.spacing)));
      return static_cast<int>(std::clamp<double>(levels, 0, scene.mesh.quiet_levels));
    }

    /// Solid fraction of the material in a cell, 1 without voids, 0 without material.
    template <int dim>
    double
    solid_fraction(const State<dim> &state, Index cell)
    {
      double solid = 0, volume = 0;
      for (const MaterialState &m : state.material)
        {
          volume += m.volume[cell];
          solid += m.volume[cell] * (m.has_voids() ? 1. - m.void_fraction[cell] : 1.);
        }
      return volume > 0 ? solid / volume : 0.;
    }
  } // namespace

  template <int dim>
  LevelNeed<dim>::LevelNeed(const Scene<dim> &scene, const FieldLayout &layout)
    : scene_(scene)
    , layout_(layout)
    , quiet_levels_(quiet_levels(scene))
  {
  }

  template <int dim>
  int
  LevelNeed<dim>::of_solid_fraction(double solid_fraction) const
  {
    const int finest = scene_.lattice.max_level;
    if (solid_fraction >= scene_.mesh.solid_fraction)
      return finest;
    const double below = std::log(solid_fraction / scene_.mesh.solid_fraction) / std::log(scene_.mesh.solid_ratio);
    return below >= finest ? 0 : finest - 1 - static_cast<int>(below);
  }

  template <int dim>
  int
  LevelNeed<dim>::of_body(const Body<dim> &body) const
  {
    const int finest = scene_.lattice.max_level;
    if (!body.is_uniform())
      return finest;
    for (const double component : body.velocity)
      if (std::abs(component) > scene_.mesh.quiet_velocity)
        return finest;
    std::array<double, 1>       pressure{}, sound_speed_squared{};
    const std::array<double, 1> density{body.density}, energy{body.energy};
    layout_.materials[body.material].eos->evaluate(density, energy, pressure, sound_speed_squared);
    const double weak = body.density * std::sqrt(std::max(sound_speed_squared[0], 0.)) * scene_.mesh.quiet_velocity;
    return std::abs(pressure[0]) <= weak ? std::max(0, finest - quiet_levels_) : finest;
  }

  template <int dim>
  int
  LevelNeed<dim>::inside_body(const Body<dim> &body) const
  {
    const int level = of_body(body);
    int       spare = 0;
    for (const auto &criterion : scene_.mesh.criteria)
      spare = std::max(spare, criterion->of_uniform_matter());
    return !body.is_uniform() ? level : std::min(level, std::max(0, scene_.lattice.max_level - spare));
  }

  template <int dim>
  bool
  LevelNeed<dim>::is_quiet(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived, Index cell) const
  {
    const double slow = scene_.mesh.quiet_velocity;
    for (int k = 0; k < FlatMesh<dim>::corners; ++k)
      for (int d = 0; d < dim; ++d)
        if (std::abs(state.velocity[d][mesh.cell_node[cell * FlatMesh<dim>::corners + k]]) > slow)
          return false;
    for (std::size_t i = 0; i < state.material.size(); ++i)
      {
        const MaterialState &m = state.material[i];
        if (m.mass[cell] == 0.)
          continue;
        const DerivedMaterial &from = derived.material[i];
        const double           weak = m.density[cell] * from.sound_speed[cell] * slow;
        bool calm = std::abs(from.pressure[cell]) <= weak && !(m.has_voids() && m.void_fraction[cell] > 0);
        for (const int s : state.index.stress)
          calm = calm && (s < 0 || std::abs(m.fields[s].value[cell]) <= weak);
        if (!calm)
          return false;
      }
    return true;
  }

  template <int dim>
  std::vector<int>
  LevelNeed<dim>::of_cells(const FlatMesh<dim> &mesh, const State<dim> &state, const Derived &derived,
                           MPI_Comm communicator) const
  {
    const CellsToJudge cells{mesh, state, derived, scene_.boundaries, scene_.lattice.spacing, communicator};
    std::vector<int>   spare(mesh.n_owned, 0);
    for (const auto &criterion : scene_.mesh.criteria)
      {
        const std::vector<int> own = criterion->spare_levels(cells);
        for (Index c = 0; c < mesh.n_owned; ++c)
          spare[c] = std::max(spare[c], own[c]);
      }
    std::vector<int> level(mesh.n_owned, -1);
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        const double solid = solid_fraction(state, c);
        if (solid == 0.)
          continue;
        const int quiet = is_quiet(mesh, state, derived, c) ? quiet_levels_ : 0;
        level[c]        = std::max(0, of_solid_fraction(solid) - std::max(quiet, spare[c]));
      }
    return level;
  }

  template <int dim>
  std::uint8_t
  LevelNeed<dim>::fixed(CellKey leaf) const
  {
    const int finest = scene_.lattice.max_level;
    if (scene_.mesh.refinement != Refinement::region)
      return static_cast<std::uint8_t>(finest);
    const LatticePoint<dim> point = key_point<dim>(leaf);
    const double            size  = scene_.lattice.spacing * scene_.lattice.extent(key_level(leaf));
    bool                    meets = true;
    for (int d = 0; d < dim; ++d)
      {
        const double lower = scene_.lattice.origin[d] + scene_.lattice.spacing * point[d];
        meets              = meets && lower < scene_.mesh.region.upper[d] && lower + size > scene_.mesh.region.lower[d];
      }
    return static_cast<std::uint8_t>(meets ? finest : finest - scene_.mesh.region_levels);
  }

  template class LevelNeed<2>;
} // namespace whipple
