// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/interface_plane.h>
#include <whipple/remap/interface_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace whipple
{
  namespace
  {
    double
    box_volume(const Symmetry symmetry, const Vector<2> &lower, const Vector<2> &upper)
    {
      const double area = (upper[0] - lower[0]) * (upper[1] - lower[1]);
      return symmetry == Symmetry::planar ? area : std::numbers::pi * (lower[0] + upper[0]) * area;
    }
  } // namespace

  template <int dim>
  InterfaceReconstruction<dim>::InterfaceReconstruction(const FlatMesh<dim> &mesh)
    : mesh_(&mesh)
    , coarse_cell_(mesh.n_nodes, none)
  {
    std::vector<std::uint8_t> hangs(mesh.n_nodes, 0);
    for (const Index h : mesh.hanging)
      hangs[h] = 1;
    for (const FlatFaces<dim> &faces : mesh.faces)
      for (Index f = 0; f < faces.size(); ++f)
        for (int s = 0; s < 2; ++s)
          if (faces.cell[s][f] != none && faces.part[s][f] >= 0)
            for (int k = 0; k < FlatFaces<dim>::corners; ++k)
              if (const Index n = faces.node[f * FlatFaces<dim>::corners + k]; hangs[n])
                coarse_cell_[n] = faces.cell[s][f];
  }

  template <int dim>
  void
  InterfaceReconstruction<dim>::restart(const Index n_mixed_cells, const Index n_materials)
  {
    n_materials_ = n_materials;
    plane_.assign(static_cast<std::size_t>(n_mixed_cells) * n_materials, Plane());
  }

  template <int dim>
  double
  InterfaceReconstruction<dim>::cumulated_fraction(const State<dim> &state, const Index cell, const Index m)
  {
    double sum = 0;
    for (Index i = 0; i <= m; ++i)
      sum += state.material[i].volume[cell];
    return std::min(sum / state.volume[cell], 1.);
  }

  template <int dim>
  Vector<dim>
  InterfaceReconstruction<dim>::fraction_gradient(const State<dim> &state, const Index cell, const Index m) const
  {
    constexpr int corners = FlatMesh<dim>::corners;
    Vector<dim>   gradient{};
    for (int k = 0; k < corners; ++k)
      {
        // mean at the node: weights 1/size interpolate linearly between cells of unequal size
        const Index node   = mesh_->cell_node[cell * corners + k];
        double      weight = 0, sum = 0;
        const auto  add = [&](const Index c) {
          const double w = 1. / mesh_->size[c];
          weight += w;
          sum += w * cumulated_fraction(state, c, m);
        };
        for (Index i = mesh_->node_corner_begin[node]; i < mesh_->node_corner_begin[node + 1]; ++i)
          add(mesh_->node_corner[i] / corners);
        if (coarse_cell_[node] != none)
          add(coarse_cell_[node]);
        for (int d = 0; d < dim; ++d)
          gradient[d] += (k >> d & 1 ? 1. : -1.) * (sum / weight);
      }
    for (int d = 0; d < dim; ++d)
      gradient[d] *= 2. / (corners * mesh_->size[cell]);
    return gradient;
  }

  template <int dim>
  typename InterfaceReconstruction<dim>::Plane
  InterfaceReconstruction<dim>::reconstruct(const State<dim> &state, const Index cell, const Index m) const
  {
    Plane plane;
    plane.known                = true;
    plane.fraction             = cumulated_fraction(state, cell, m);
    const Vector<dim> gradient = fraction_gradient(state, cell, m);
    double            length   = 0;
    for (int d = 0; d < dim; ++d)
      length += gradient[d] * gradient[d];
    length = std::sqrt(length);
    // what is left of a gradient by round-off has no direction
    plane.flat = !(length * mesh_->size[cell] > 1e-12);
    if (plane.flat)
      return plane;
    Vector<dim> lower, upper;
    for (int d = 0; d < dim; ++d)
      {
        plane.normal[d] = -gradient[d] / length;
        lower[d]        = mesh_->lower[d][cell];
        upper[d]        = lower[d] + mesh_->size[cell];
      }
    plane.offset =
        interface_plane::offset_of_fraction<dim>(mesh_->symmetry, lower, upper, plane.normal, plane.fraction);
    return plane;
  }

  template <int dim>
  double
  InterfaceReconstruction<dim>::filled_share(const State<dim> &state, const Index place, const Index cell,
                                             const Index m, const Vector<dim> &box_lower, const Vector<dim> &box_upper)
  {
    Plane &plane = plane_[static_cast<std::size_t>(place) * n_materials_ + m];
    if (!plane.known)
      plane = reconstruct(state, cell, m);
    if (plane.flat || plane.fraction <= 0 || plane.fraction >= 1)
      return plane.fraction;
    Vector<dim> origin;
    for (int d = 0; d < dim; ++d)
      origin[d] = mesh_->lower[d][cell];
    const double below =
        interface_plane::volume_below<dim>(mesh_->symmetry, box_lower, box_upper, origin, plane.normal, plane.offset);
    return below / box_volume(mesh_->symmetry, box_lower, box_upper);
  }

  template class InterfaceReconstruction<2>;
} // namespace whipple
