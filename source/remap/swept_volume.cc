// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/swept_volume.h>

#include <numbers>

namespace whipple
{
  namespace
  {
    /// Volume of the triangle p, p + u, p + v, counter-clockwise positive.
    template <Symmetry symmetry>
    double
    triangle_volume(const double r, const double u0, const double u1, const double v0, const double v1)
    {
      const double area = 0.5 * (u0 * v1 - u1 * v0);
      if constexpr (symmetry == Symmetry::planar)
        return area;
      else
        return 2. * std::numbers::pi * area * (r + (u0 + v0) / 3.);
    }

    template <int dim, Symmetry symmetry>
    void
    sweep_faces(const FlatMesh<dim> &mesh, const State<dim> &state, const int axis, std::vector<double> &swept)
    {
      const FlatFaces<dim> &faces       = mesh.faces[axis];
      const double          orientation = axis == 0 ? 1. : -1.;
      for (Index f = 0; f < faces.size(); ++f)
        {
          const Index  a = faces.node[2 * f], b = faces.node[2 * f + 1];
          const double a0 = mesh.node_point[0][a], a1 = mesh.node_point[1][a];
          const double b0 = mesh.node_point[0][b] - a0, b1 = mesh.node_point[1][b] - a1;
          // displacement of both ends, and the moved end b seen from the fixed end a
          const double ua0 = state.position[0][a] - a0, ua1 = state.position[1][a] - a1;
          const double mb0 = state.position[0][b] - a0, mb1 = state.position[1][b] - a1;
          swept[f] = orientation * (triangle_volume<symmetry>(a0, b0, b1, mb0, mb1) +
                                    triangle_volume<symmetry>(a0, mb0, mb1, ua0, ua1));
        }
    }
  } // namespace

  template <int dim>
  void
  compute_swept_volumes(const FlatMesh<dim> &mesh, const State<dim> &state, const int axis, std::vector<double> &swept)
  {
    if (mesh.symmetry == Symmetry::planar)
      sweep_faces<dim, Symmetry::planar>(mesh, state, axis, swept);
    else
      sweep_faces<dim, Symmetry::axisymmetric>(mesh, state, axis, swept);
  }

  template void
  compute_swept_volumes<2>(const FlatMesh<2> &, const State<2> &, int, std::vector<double> &);
} // namespace whipple
