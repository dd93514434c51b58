// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/mesh_point.h>
#include <whipple/mesh/cell_corners.h>
#include <whipple/state/corner_velocity.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace whipple
{
  namespace
  {
    /// By how much of an element's width a point may lie outside it: the round-off of positions, not a distance.
    constexpr double tolerance = 1e-9;

    std::array<double, 4>
    shape_functions(const Vector<2> &local)
    {
      const double a = local[0], b = local[1];
      return {{(1. - a) * (1. - b), a * (1. - b), (1. - a) * b, a * b}};
    }

    bool
    in_box(const CornerVectors<2> &x, const Vector<2> &point)
    {
      for (int d = 0; d < 2; ++d)
        {
          const auto [least, most] = std::minmax_element(x[d].begin(), x[d].end());
          const double slack       = tolerance * (*most - *least);
          if (point[d] < *least - slack || point[d] > *most + slack)
            return false;
        }
      return true;
    }

    /// Newton's method for the point of the unit square whose image is x, from its middle. False if it leaves the
    /// square or the element is folded there.
    bool
    invert(const CornerVectors<2> &corner, const Vector<2> &x, Vector<2> &local)
    {
      constexpr int most_iterations = 30;
      local                         = {{0.5, 0.5}};
      for (int i = 0; i < most_iterations; ++i)
        {
          const std::array<double, 4> n = shape_functions(local);
          double                      residual[2], along[2][2];
          for (int d = 0; d < 2; ++d)
            {
              const auto &c = corner[d];
              residual[d]   = x[d] - (n[0] * c[0] + n[1] * c[1] + n[2] * c[2] + n[3] * c[3]);
              along[d][0]   = (1. - local[1]) * (c[1] - c[0]) + local[1] * (c[3] - c[2]);
              along[d][1]   = (1. - local[0]) * (c[2] - c[0]) + local[0] * (c[3] - c[1]);
            }
          const double determinant = along[0][0] * along[1][1] - along[0][1] * along[1][0];
          if (!(std::abs(determinant) > 0))
            return false;
          const double step[2] = {(residual[0] * along[1][1] - residual[1] * along[0][1]) / determinant,
                                  (along[0][0] * residual[1] - along[1][0] * residual[0]) / determinant};
          local[0] += step[0];
          local[1] += step[1];
          if (!(std::abs(local[0]) < 1e3 && std::abs(local[1]) < 1e3))
            return false;
          if (std::abs(step[0]) + std::abs(step[1]) < 1e-14)
            break;
        }
      return std::all_of(local.begin(), local.end(), [](double l) { return l >= -tolerance && l <= 1. + tolerance; });
    }
  } // namespace

  template <int dim>
  Index
  cell_of_key(const FlatMesh<dim> &mesh, CellKey key)
  {
    const auto end   = mesh.key.begin() + mesh.n_owned;
    const auto found = std::find(mesh.key.begin(), end, key);
    return found == end ? none : static_cast<Index>(found - mesh.key.begin());
  }

  template <int dim>
  MeshPoint<dim>
  find_in_lattice(const Lattice<dim> &lattice, const FlatMesh<dim> &mesh, const State<dim> &state, const Vector<dim> &x)
  {
    LatticePoint<dim> finest;
    for (int d = 0; d < dim; ++d)
      {
        const double place = (x[d] - lattice.origin[d]) / lattice.spacing;
        if (!(place >= 0 && place <= lattice.finest(d) + tolerance))
          return {};
        finest[d] = std::min(static_cast<int>(std::floor(place)), lattice.finest(d) - 1);
      }
    for (int level = lattice.max_level; level >= 0; --level)
      {
        LatticePoint<dim> lower = finest;
        for (int &p : lower)
          p -= p % lattice.extent(level);
        const Index c = cell_of_key(mesh, make_key<dim>(level, lower));
        if (c == none)
          continue;
        MeshPoint<dim> point{cell_mass(state, c) > 0 ? c : none, {}};
        for (int d = 0; d < dim; ++d)
          point.local[d] = (x[d] - mesh.lower[d][c]) / mesh.size[c];
        return point;
      }
    return {};
  }

  template <int dim>
  MeshPoint<dim>
  find_in_elements(const FlatMesh<dim> &mesh, const State<dim> &state, const Vector<dim> &x)
  {
    MeshPoint<dim> best;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        if (best.cell != none && mesh.key[c] > mesh.key[best.cell])
          continue;
        const CornerVectors<2> corner = cell_corners(mesh, state.position, c);
        Vector<dim>            local{};
        if (in_box(corner, x) && cell_mass(state, c) > 0 && invert(corner, x, local))
          best = {c, local};
      }
    return best;
  }

  template <int dim>
  Vector<dim>
  at_point(const FlatMesh<dim> &mesh, const std::array<std::vector<double>, dim> &nodal, const MeshPoint<dim> &point)
  {
    const std::array<double, 4> n = shape_functions(point.local);
    Vector<dim>                 value{};
    for (int k = 0; k < FlatMesh<dim>::corners; ++k)
      for (int d = 0; d < dim; ++d)
        value[d] += n[k] * nodal[d][mesh.cell_node[point.cell * FlatMesh<dim>::corners + k]];
    return value;
  }

  template Index
  cell_of_key<2>(const FlatMesh<2> &, CellKey);
  template MeshPoint<2>
  find_in_lattice<2>(const Lattice<2> &, const FlatMesh<2> &, const State<2> &, const Vector<2> &);
  template MeshPoint<2>
  find_in_elements<2>(const FlatMesh<2> &, const State<2> &, const Vector<2> &);
  template Vector<2>
  at_point<2>(const FlatMesh<2> &, const std::array<std::vector<double>, 2> &, const MeshPoint<2> &);
} // namespace whipple
