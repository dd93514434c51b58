// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/body_share.h>
#include <whipple/diagnostics/plate_cells.h>
#include <whipple/diagnostics/plate_measure.h>
#include <whipple/error.h>
#include <whipple/mesh/gather.h>
#include <whipple/problem/material_effects.h>
#include <whipple/scene/body_volume.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace whipple
{
  namespace
  {
    /// Part of its density on entry below which material is debris cloud, no longer plate.
    constexpr double least_density = 0.5;

    /// Whether the left or right side halves the scene: the axis, or a wall that stands for a plane of symmetry. Of two
    /// walls it is the one at 0, around which plates lie.
    template <int dim>
    bool
    halves(const Scene<dim> &scene, int side)
    {
      if (scene.lattice.symmetry == Symmetry::axisymmetric)
        return side == 0;
      const auto is_wall = [&](int s) { return scene.boundaries[s].kind == BoundaryKind::reflecting; };
      const auto place   = [&](int s) { return s == 0 ? scene.lattice.origin[0] : scene.upper_corner()[0]; };
      return is_wall(side) && (!is_wall(1 - side) || std::abs(place(side)) <= 1e-9 * scene.lattice.spacing);
    }

    template <int dim>
    bool
    is_turned(const Scene<dim> &scene)
    {
      return halves(scene, 1) && !halves(scene, 0);
    }

    template <int dim>
    double
    plate_mass(const Scene<dim> &scene, const Body<dim> &body)
    {
      return body.density *
             body_volume<dim>(scene.lattice.symmetry, body.shape, scene.lattice.origin, scene.upper_corner());
    }
  } // namespace

  template <int dim>
  PlateSite
  plate_site(const Scene<dim> &scene, std::size_t body)
  {
    const auto *plate = scene.bodies[body].shape.template as<Plate<dim>>();
    if (!plate)
      throw Error("body '" + scene.bodies[body].name + "' is no plate and has no hole to measure");
    const Lattice<dim> &lattice = scene.lattice;
    PlateSite           site{lattice.symmetry,
                   lattice.origin,
                   lattice.spacing,
                   lattice.finest(0),
                   *plate,
                   plate_mass(scene, scene.bodies[body]),
                   false};
    site.half = halves(scene, 0) || halves(scene, 1);
    if (is_turned(scene))
      site.origin[0] = -scene.upper_corner()[0];
    return site;
  }

  template <int dim>
  std::vector<PlateCell>
  plate_cells(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const FlatMesh<dim> &mesh,
              const State<dim> &state)
  {
    const Lattice<dim>  &lattice = scene.lattice;
    const MaterialState &m       = state.material[layout.body_material[body]];
    const double solid = 1. - sections::initial_void_fraction(layout.materials[layout.body_material[body]]); // on entry
    const bool   turned = is_turned(scene);
    std::vector<PlateCell> cells;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        if (m.mass[c] == 0.)
          continue;
        const double share = share_of_body(scene, layout, body, m, c);
        if (!(share > 0))
          continue;
        const LatticePoint<dim> point = key_point<dim>(mesh.key[c]);
        PlateCell               cell{{{point[0], point[1]}}, lattice.extent(mesh.level[c])};
        if (turned)
          cell.lower[0] = lattice.finest(0) - cell.upper(0);
        cell.fill          = share * m.volume[c] / state.volume[c];
        const double dense = m.has_voids() ? std::min((1. - m.void_fraction[c]) / solid, 1.) : 1.;
        cell.solid         = dense * cell.fill;
        cell.mass          = share * m.mass[c];
        cell.dense         = m.density[c] >= least_density * scene.bodies[body].density;
        cells.push_back(cell);
      }
    return cells;
  }

  template <int dim>
  std::optional<PlateMeasure>
  measure_plate(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const FlatMesh<dim> &mesh,
                const State<dim> &state, MPI_Comm communicator)
  {
    const PlateSite              site = plate_site(scene, body);
    const std::vector<PlateCell> mine = plate_cells(scene, layout, body, mesh, state);
    std::vector<PlateCell>       all  = gather_on_first(communicator, std::span<const PlateCell>(mine));
    struct
    {
      PlateMeasure measure;
      int          seen;
    } result{{}, 0};
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    if (rank == 0)
      if (const auto measure = measure_plate(site, std::move(all)))
        result = {*measure, 1};
    static_assert(std::is_trivially_copyable_v<decltype(result)>);
    MPI_Bcast(&result, sizeof(result), MPI_BYTE, 0, communicator);
    return result.seen ? std::optional<PlateMeasure>(result.measure) : std::nullopt;
  }

  template <int dim>
  std::vector<std::size_t>
  measured_plates(const Scene<dim> &scene, std::size_t stage)
  {
    std::vector<std::size_t> plates;
    for (std::size_t s = stage + 1; s-- > 0 && scene.stages[s].mode() == StageMode::eulerian;)
      for (const std::size_t body : scene.stages[s].introduces)
        if (scene.bodies[body].shape.template as<Plate<dim>>())
          plates.push_back(body);
    return plates;
  }

  template std::vector<std::size_t>
  measured_plates(const Scene<2> &, std::size_t);
  template PlateSite
  plate_site(const Scene<2> &, std::size_t);
  template std::vector<PlateCell>
  plate_cells(const Scene<2> &, const FieldLayout &, std::size_t, const FlatMesh<2> &, const State<2> &);
  template std::optional<PlateMeasure>
  measure_plate(const Scene<2> &, const FieldLayout &, std::size_t, const FlatMesh<2> &, const State<2> &, MPI_Comm);
} // namespace whipple
