// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/hydro/fragment_release.h>
#include <whipple/mesh/geometry.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// Whether the quadrilateral is about to fold.
    bool
    folds(const geometry::Quad &x, double least_jacobian)
    {
      const auto   j    = geometry::corner_jacobian(x);
      const double mean = 0.25 * (j[0] + j[1] + j[2] + j[3]);
      return std::min(std::min(j[0], j[1]), std::min(j[2], j[3])) < least_jacobian * mean || mean <= 0;
    }

    bool
    shares_nodes(const FlatMesh<2> &mesh, Index c)
    {
      bool shares = false;
      for (int k = 0; k < 4; ++k)
        {
          const Index n = mesh.cell_node[4 * c + k];
          shares        = shares || mesh.node_corner_begin[n + 1] - mesh.node_corner_begin[n] > 1;
        }
      return shares;
    }

    /// Give all corners of a cell one velocity; returns the kinetic energy of the relative motion.
    double
    make_rigid(const FlatMesh<2> &mesh, State<2> &state, Index c, bool at_axis)
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
          const double mean = d == 0 && at_axis ? 0. : momentum / mass;
          after += 0.5 * mass * mean * mean;
          for (int k = 0; k < 4; ++k)
            state.velocity[d][mesh.cell_node[4 * c + k]] = mean;
        }
      for (MaterialState &m : state.material)
        if (m.mass[c] > 0)
          m.energy[c] += (before - after) / mass;
      return before - after;
    }
  } // namespace

  template <int dim>
  ReleaseReport
  release_fragments(const FlatMesh<dim> &mesh, State<dim> &state, double dt, double least_jacobian)
  {
    static_assert(dim == 2);
    const bool    axisymmetric = mesh.symmetry == Symmetry::axisymmetric;
    ReleaseReport report;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        if (mesh.intact[c] && shares_nodes(mesh, c))
          continue;
        geometry::Quad now, next;
        bool           rigid = true, crosses_axis = false, at_axis = false;
        for (int k = 0; k < 4; ++k)
          {
            const Index n = mesh.cell_node[4 * c + k];
            for (int d = 0; d < 2; ++d)
              {
                now[d][k]  = state.position[d][n];
                next[d][k] = now[d][k] + dt * state.velocity[d][n];
                rigid      = rigid && state.velocity[d][n] == state.velocity[d][mesh.cell_node[4 * c]];
              }
            crosses_axis = crosses_axis || (axisymmetric && next[0][k] < 0);
            at_axis      = at_axis || (axisymmetric && (mesh.node_side[n] & 1));
          }
        if (!crosses_axis && (rigid || !folds(next, least_jacobian)))
          continue;
        report.kinetic_loss += make_rigid(mesh, state, c, at_axis || crosses_axis);
        ++report.released;
      }
    return report;
  }

  template ReleaseReport
  release_fragments(const FlatMesh<2> &, State<2> &, double, double);
} // namespace whipple
