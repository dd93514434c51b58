// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/initial/initial_state.h>
#include <whipple/initial/painted_bodies.h>
#include <whipple/initial/painting.h>
#include <whipple/mesh/collective.h>
#include <whipple/problem/material_effects.h>
#include <whipple/scene/body_volume.h>
#include <whipple/scene/box_shape.h>
#include <whipple/state/round_off_share.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace whipple
{
  namespace
  {
    /// Range of lattice coordinates, widened to multiples of `step`, that the extent of a shape covers on one axis.
    template <int dim>
    std::array<int, 2>
    covered_range(const Lattice<dim> &lattice, const Box<dim> &box, int axis, int step)
    {
      const double length = lattice.finest(axis);
      const double low    = (box.lower[axis] - lattice.origin[axis]) / lattice.spacing;
      const double high   = (box.upper[axis] - lattice.origin[axis]) / lattice.spacing;
      return {{static_cast<int>(std::floor(std::clamp(low, 0., length) / step)) * step,
               static_cast<int>(std::ceil(std::clamp(high, 0., length) / step)) * step}};
    }

    template <int dim>
    Vector<dim>
    position(const Lattice<dim> &lattice, const LatticePoint<dim> &point)
    {
      Vector<dim> x;
      for (int d = 0; d < dim; ++d)
        x[d] = lattice.origin[d] + lattice.spacing * point[d];
      return x;
    }

    /// A solution that fills bodies, and the cells that hold nothing else.
    template <int dim>
    struct SolutionFilling
    {
      const exact::ExactSolution<dim> *solution;
      ExactFilling<dim>                filling;
      std::vector<std::uint8_t>        alone;
    };

    /// One for each solution that bodies start from.
    template <int dim>
    std::vector<SolutionFilling<dim>>
    solution_fillings(const Problem<dim> &problem, std::span<const std::size_t> bodies, const FlatMesh<dim> &mesh,
                      const State<dim> &state)
    {
      std::vector<SolutionFilling<dim>> all;
      for (const std::size_t b : bodies)
        if (const auto *solution = problem.initial_solution(b);
            solution && std::none_of(all.begin(), all.end(), [&](const auto &f) { return f.solution == solution; }))
          all.push_back({solution, ExactFilling<dim>(*solution, problem.layout, mesh, state),
                         std::vector<std::uint8_t>(mesh.n_cells, 0)});
      return all;
    }

    /// Add one body to one cell; returns the mass added.
    template <int dim>
    double
    paint_cell(const CellFilling<dim> &filling, double void_fraction, int tag, double volume, Index c, MaterialState &m)
    {
      const double mass = filling.density * volume, total = m.mass[c] + mass;
      m.energy[c] += (filling.energy - m.energy[c]) * mass / total;
      for (std::size_t f = 0; f < m.fields.size(); ++f)
        if (m.fields[f].description.carrier == Carrier::mass)
          {
            const double own = static_cast<int>(f) == tag ? 1. : 0.;
            m.fields[f].value[c] += (own - m.fields[f].value[c]) * mass / total;
          }
      m.volume[c] += volume;
      m.mass[c] = total;
      if (m.has_voids())
        m.void_fraction[c] += (void_fraction - m.void_fraction[c]) * (volume / m.volume[c]);
      // a single body keeps its density to the last bit
      m.density[c] = m.density[c] == 0. || m.density[c] == filling.density ? filling.density : total / m.volume[c];
      return mass;
    }

    template <int dim>
    CellFilling<dim>
    uniform_filling(const Body<dim> &body)
    {
      CellFilling<dim> filling{body.density, body.energy, {}};
      filling.velocity.fill(body.velocity);
      return filling;
    }

    /// Mix the velocities of a body that adds a mass to a cell into its corners. What meets there moves on together:
    /// the kinetic energy of its relative motion becomes the cell's remainder, which heats it.
    template <int dim>
    void
    blend_velocity(const CellFilling<dim> &filling, double before, double added, Index c, const State<dim> &state,
                   CornerVelocities<dim> &corners)
    {
      constexpr int n     = FlatMesh<dim>::corners;
      const double  share = added / (before + added);
      for (int d = 0; d < dim; ++d)
        for (int k = 0; k < n; ++k)
          {
            double      &u    = corners.velocity[d][c * n + k];
            const double slip = filling.velocity[k][d] - u;
            u                 = share == 1. ? filling.velocity[k][d] : u + share * slip;
            corners.kinetic_remainder[c] += 0.5 * state.corner_weight[c * n + k] * (before * share) * slip * slip;
          }
    }

    template <int dim>
    void
    deposit_energy(const Body<dim> &body, Index material, const FlatMesh<dim> &mesh, MPI_Comm communicator,
                   State<dim> &state)
    {
      CellKey best = ~CellKey{0};
      Index   cell = none;
      for (Index c = 0; c < mesh.n_cells; ++c)
        {
          bool inside = true;
          for (int d = 0; d < dim; ++d)
            {
              const double x = body.deposit->point[d] - mesh.lower[d][c];
              inside         = inside && x >= 0 && x <= mesh.size[c];
            }
          if (inside && mesh.key[c] < best)
            {
              best = mesh.key[c];
              cell = c;
            }
        }
      CellKey least = best;
      MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_UINT64_T, MPI_MIN, communicator);
      MaterialState &m     = state.material[material];
      double         found = best == least && cell != none ? m.mass[cell] : 0.;
      if (found > 0)
        m.energy[cell] += body.deposit->energy / found;
      MPI_Allreduce(MPI_IN_PLACE, &found, 1, MPI_DOUBLE, MPI_MAX, communicator);
      if (found == 0)
        throw StateError("the energy deposit of body '" + body.name + "' finds no material at its point");
    }
  } // namespace

  namespace
  {
    /// Whether a box of lattice coordinates, widened by `margin` as far as the domain reaches, lies inside a shape.
    template <int dim>
    bool
    is_interior(const Lattice<dim> &lattice, const Shape<dim> &shape, LatticePoint<dim> lower, LatticePoint<dim> upper,
                int margin)
    {
      for (int d = 0; d < dim; ++d)
        {
          lower[d] = std::max(lower[d] - margin, 0);
          upper[d] = std::min(upper[d] + margin, lattice.finest(d));
        }
      const Vector<dim> from = position<dim>(lattice, lower), to = position<dim>(lattice, upper);
      const double      whole = box_volume(lattice.symmetry, from, to);
      return body_volume<dim>(lattice.symmetry, shape, from, to) > (1. - 1e-9) * whole;
    }
  } // namespace

  template <int dim>
  void
  request_bodies(const Scene<dim> &scene, const LevelNeed<dim> *need, std::span<const std::size_t> bodies,
                 RefinementMap<dim> &map)
  {
    static_assert(dim == 2);
    const Lattice<dim> &lattice = scene.lattice;
    for (const std::size_t b : bodies)
      {
        if (const auto &deposit = scene.bodies[b].deposit)
          map.request(lattice.max_level, deposit->point, deposit->point, scene.mesh.buffer);
        const int      level  = need ? need->of_body(scene.bodies[b]) : lattice.max_level;
        const int      inside = need ? need->inside_body(scene.bodies[b]) : level;
        const int      block  = lattice.extent(std::max(level - 2, 0));
        const int      margin = scene.mesh.buffer * lattice.extent(level);
        const Box<dim> box    = extent(scene.bodies[b].shape);
        const auto     i      = covered_range(lattice, box, 0, block);
        const auto     j      = covered_range(lattice, box, 1, block);
        for (int x = i[0]; x < i[1]; x += block)
          for (int y = j[0]; y < j[1]; y += block)
            {
              const LatticePoint<dim> lower{{x, y}}, upper{{x + block, y + block}};
              if (body_volume<dim>(lattice.symmetry, scene.bodies[b].shape, position<dim>(lattice, lower),
                                   position<dim>(lattice, upper)) > 0)
                map.request(inside < level && is_interior<dim>(lattice, scene.bodies[b].shape, lower, upper, margin)
                                ? inside
                                : level,
                            lower, upper, scene.mesh.buffer);
            }
      }
  }

  namespace
  {
    /// What a body takes of a cell.
    struct Cut
    {
      double volume  = 0; ///< true volume, cm^3
      double rounded = 0; ///< cm^3 that are left out as round-off
    };

    template <int dim>
    Cut
    cut_of_cell(const Scene<dim> &scene, const Body<dim> &body, const Box<dim> &box, const FlatMesh<dim> &mesh,
                const State<dim> &state, Index c)
    {
      Vector<dim> lower, upper;
      for (int d = 0; d < dim; ++d)
        {
          lower[d] = mesh.lower[d][c];
          upper[d] = lower[d] + mesh.size[c];
          if (!(lower[d] < box.upper[d] && upper[d] > box.lower[d]))
            return {};
        }
      // on a mapped mesh bodies are cut on the lattice
      const double whole = state.volume[c];
      const double volume =
          scene.mesh_map == MeshMap::identity
              ? body_volume<dim>(mesh.symmetry, body.shape, lower, upper)
              : body_volume<dim>(Symmetry::planar, body.shape, lower, upper) / (mesh.size[c] * mesh.size[c]) * whole;
      if (volume < round_off_share * whole)
        return {0., std::max(volume, 0.)};
      return {std::abs(volume - whole) < round_off_share * whole ? whole : volume, 0.};
    }
  } // namespace

  template <int dim>
  Booking<dim>
  paint_bodies(const Problem<dim> &problem, std::span<const std::size_t> bodies, const FlatMesh<dim> &mesh,
               MPI_Comm communicator, State<dim> &state)
  {
    const Scene<dim>     &scene      = problem.scene;
    const FieldLayout    &layout     = problem.layout;
    CornerVelocities<dim> velocities = corner_velocities(mesh, state);
    PaintedBodies<dim>    books(scene, bodies);
    std::vector<Box<dim>> boxes;
    for (const std::size_t b : bodies)
      boxes.push_back(extent(scene.bodies[b].shape));
    std::vector<SolutionFilling<dim>> fillings;
    agree(communicator, [&] {
      fillings = solution_fillings(problem, bodies, mesh, state);
      for (Index c = 0; c < mesh.n_cells; ++c)
        for (std::size_t i = 0; i < bodies.size(); ++i)
          {
            const std::size_t b          = bodies[i];
            const Body<dim>  &body       = scene.bodies[b];
            const auto [volume, rounded] = cut_of_cell(scene, body, boxes[i], mesh, state, c);
            if (c < mesh.n_owned)
              books.add(i, volume, rounded);
            if (volume <= 0)
              continue;
            const auto             own     = std::find_if(fillings.begin(), fillings.end(),
                                                          [&](const auto &f) { return f.solution == problem.initial_solution(b); });
            const bool             uniform = own == fillings.end();
            const CellFilling<dim> filling = uniform ? uniform_filling(body) : own->filling.fill(body, state, c);
            const double           before  = cell_mass(state, c);
            const double           pores   = sections::initial_void_fraction(layout.materials[body.material]);
            const double           added =
                paint_cell(filling, pores, layout.body_tag[b], volume, c, state.material[layout.body_material[b]]);
            blend_velocity<dim>(filling, before, added, c, state, velocities);
            for (SolutionFilling<dim> &f : fillings)
              f.alone[c] = !uniform && &f == std::to_address(own) && before == 0.;
          }
    });
    books.check(communicator);
    for (const SolutionFilling<dim> &f : fillings)
      f.filling.add_hanging_energy(state, f.alone, velocities);
    for (const std::size_t b : bodies)
      if (scene.bodies[b].deposit)
        deposit_energy(scene.bodies[b], layout.body_material[b], mesh, communicator, state);
    return gather_velocities(mesh, scene.boundaries, velocities, KineticLoss::heat, state);
  }

  template void
  request_bodies(const Scene<2> &, const LevelNeed<2> *, std::span<const std::size_t>, RefinementMap<2> &);
  template Booking<2>
  paint_bodies(const Problem<2> &, std::span<const std::size_t>, const FlatMesh<2> &, MPI_Comm, State<2> &);
} // namespace whipple
