// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/cell_shape.h>
#include <whipple/hydro/fragment_release.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// What ends a fragment's freedom in the next step.
    struct Obstacles
    {
      bool                rigid  = true;  ///< all corners have one velocity already
      bool                passes = false; ///< a corner is about to go through the axis or a wall
      std::array<bool, 2> held{};         ///< along which axes it may not move
    };

    Obstacles
    obstacles(const FlatMesh<2> &mesh, const RigidWalls<2> &walls, const State<2> &state, Index c,
              const CornerVectors<2> &next)
    {
      const bool axisymmetric = mesh.symmetry == Symmetry::axisymmetric;
      Obstacles  result;
      for (int k = 0; k < 4; ++k)
        {
          const Index n = mesh.cell_node[4 * c + k];
          for (int d = 0; d < 2; ++d)
            result.rigid = result.rigid && state.velocity[d][n] == state.velocity[d][mesh.cell_node[4 * c]];
          result.passes  = result.passes || (axisymmetric && next[0][k] < 0);
          result.held[0] = result.held[0] || (axisymmetric && (mesh.node_side[n] & 1));
          for (int side = 0; side < 4; ++side)
            {
              const int d = side / 2;
              if (!walls.there[side])
                continue;
              const double outwards = side % 2 ? 1. : -1.;
              const bool   through =
                  outwards * (next[d][k] - walls.position[side]) > 0 && outwards * state.velocity[d][n] > 0;
              result.passes  = result.passes || through;
              result.held[d] = result.held[d] || through || (mesh.node_side[n] >> side & 1);
            }
        }
      for (int k = 0; k < 4; ++k)
        result.held[0] = result.held[0] || (axisymmetric && next[0][k] < 0);
      return result;
    }

    /// Sums over the fragments that are made rigid.
    struct Sums
    {
      Index     released     = 0;
      double    kinetic_loss = 0;
      Vector<2> wall_impulse{};
    };

    /// Give all corners of a cell one velocity; its kinetic energy of relative motion heats it.
    void
    make_rigid(const FlatMesh<2> &mesh, State<2> &state, Index c, const std::array<bool, 2> &held, Sums &sums)
    {
      double mass = 0, before = 0, after = 0;
      for (const MaterialState &m : state.material)
        mass += m.mass[c];
      for (int d = 0; d < 2; ++d)
        {
          double momentum = 0;
          for (int k = 0; k < 4; ++k)
            {
              const double v = state.velocity[d][mesh.cell_node[4 * c + k]], w = mass * state.corner_weight[4 * c + k];
              momentum += w * v;
              before += 0.5 * w * v * v;
            }
          const double mean = held[d] ? 0. : momentum / mass;
          if (held[d])
            sums.wall_impulse[d] += momentum;
          after += 0.5 * mass * mean * mean;
          for (int k = 0; k < 4; ++k)
            state.velocity[d][mesh.cell_node[4 * c + k]] = mean;
        }
      for (MaterialState &m : state.material)
        if (m.mass[c] > 0)
          m.energy[c] += (before - after) / mass;
      sums.kinetic_loss += before - after;
      ++sums.released;
    }
  } // namespace

  template <int dim>
  Released<dim>
  release_fragments(const FlatMesh<dim> &mesh, const RigidWalls<dim> &walls, State<dim> &state, double dt,
                    std::span<const Index> forced, double least_jacobian)
  {
    static_assert(dim == 2);
    Released<dim> result;
    Sums          sums;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        if (mesh.intact[c] && cell_shape::shares_nodes(mesh, c))
          continue;
        const CornerVectors<2> next   = cell_shape::corners_after(mesh, state, c, dt);
        const Obstacles        met    = obstacles(mesh, walls, state, c, next);
        const bool             locked = std::binary_search(forced.begin(), forced.end(), c);
        const bool             stop   = locked || CellShape<2>::folds(next, least_jacobian);
        if (met.passes || (stop && !met.rigid))
          make_rigid(mesh, state, c, met.held, sums);
        if (met.passes || locked)
          result.rigid.push_back({c, met.held});
      }
    result.number                          = sums.released;
    result.booking                         = lost_kinetic_energy<dim>(sums.kinetic_loss, KineticLoss::heat);
    result.booking.left.emplace().momentum = sums.wall_impulse;
    return result;
  }

  template Released<2>
  release_fragments(const FlatMesh<2> &, const RigidWalls<2> &, State<2> &, double, std::span<const Index>, double);
} // namespace whipple
