// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/scene/body_volume.h>
#include <whipple/stage/painting.h>

#include <algorithm>
#include <cmath>
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

    /// Add one body to one cell; returns the mass added.
    template <int dim>
    double
    paint_cell(const Body<dim> &body, int tag, double volume, Index c, MaterialState &m)
    {
      const double mass = body.density * volume, total = m.mass[c] + mass;
      m.energy[c] += (body.energy - m.energy[c]) * mass / total;
      for (std::size_t f = 0; f < m.fields.size(); ++f)
        if (m.fields[f].description.carrier == Carrier::mass)
          {
            const double own = static_cast<int>(f) == tag ? 1. : 0.;
            m.fields[f].value[c] += (own - m.fields[f].value[c]) * mass / total;
          }
      m.volume[c] += volume;
      m.mass[c] = total;
      // a single body keeps its density to the last bit
      m.density[c] = m.density[c] == 0. || m.density[c] == body.density ? body.density : total / m.volume[c];
      return mass;
    }

    /// Mix a body's velocity into the corners of a cell in which it now has that share of the mass.
    template <int dim>
    void
    blend_velocity(const Vector<dim> &velocity, double share, Index c, CornerVelocities<dim> &corners)
    {
      for (int d = 0; d < dim; ++d)
        for (int k = 0; k < FlatMesh<dim>::corners; ++k)
          {
            double &u = corners.velocity[d][c * FlatMesh<dim>::corners + k];
            u         = share == 1. ? velocity[d] : u + share * (velocity[d] - u);
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

  template <int dim>
  void
  request_bodies(const Scene<dim> &scene, std::span<const std::size_t> bodies, RefinementMap<dim> &map)
  {
    static_assert(dim == 2);
    const Lattice<dim> &lattice = scene.lattice;
    const int           block   = lattice.extent(std::max(lattice.max_level - 2, 0));
    for (const std::size_t b : bodies)
      {
        const Box<dim> box = extent(scene.bodies[b].shape);
        const auto     i   = covered_range(lattice, box, 0, block);
        const auto     j   = covered_range(lattice, box, 1, block);
        for (int x = i[0]; x < i[1]; x += block)
          for (int y = j[0]; y < j[1]; y += block)
            {
              const LatticePoint<dim> lower{{x, y}}, upper{{x + block, y + block}};
              if (body_volume<dim>(lattice.symmetry, scene.bodies[b].shape, position<dim>(lattice, lower),
                                   position<dim>(lattice, upper)) > 0)
                map.request(lattice.max_level, lower, upper, scene.mesh.buffer);
            }
      }
  }

  template <int dim>
  GatherReport<dim>
  paint_bodies(const Scene<dim> &scene, const FieldLayout &layout, std::span<const std::size_t> bodies,
               const FlatMesh<dim> &mesh, MPI_Comm communicator, State<dim> &state)
  {
    CornerVelocities<dim> velocities = corner_velocities(mesh, state);
    for (Index c = 0; c < mesh.n_cells; ++c)
      {
        Vector<dim> lower, upper;
        for (int d = 0; d < dim; ++d)
          {
            lower[d] = mesh.lower[d][c];
            upper[d] = lower[d] + mesh.size[c];
          }
        for (const std::size_t b : bodies)
          {
            const Body<dim> &body   = scene.bodies[b];
            double           volume = body_volume<dim>(mesh.symmetry, body.shape, lower, upper);
            // a cell that is full but for the round-off of the cut is full
            if (std::abs(volume - state.volume[c]) < 1e-10 * state.volume[c])
              volume = state.volume[c];
            if (volume <= 0)
              continue;
            const double before = cell_mass(state, c);
            const double added =
                paint_cell(body, layout.body_tag[b], volume, c, state.material[layout.body_material[b]]);
            blend_velocity<dim>(body.velocity, added / (before + added), c, velocities);
          }
      }
    for (const std::size_t b : bodies)
      if (scene.bodies[b].deposit)
        deposit_energy(scene.bodies[b], layout.body_material[b], mesh, communicator, state);
    return gather_velocities(mesh, scene.boundaries, velocities, KineticLoss::heat, state);
  }

  template void
  request_bodies(const Scene<2> &, std::span<const std::size_t>, RefinementMap<2> &);
  template GatherReport<2>
  paint_bodies(const Scene<2> &, const FieldLayout &, std::span<const std::size_t>, const FlatMesh<2> &, MPI_Comm,
               State<2> &);
} // namespace whipple
