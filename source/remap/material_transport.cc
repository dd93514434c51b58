// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/remap/limited_slope.h>
#include <whipple/remap/material_transport.h>

#include <algorithm>
#include <cmath>

namespace whipple
{
  template <int dim>
  MaterialTransport<dim>::MaterialTransport(const FlatMesh<dim> &mesh, const Boundaries<dim> &boundaries,
                                            const RemapParameters &parameters)
    : mesh_(&mesh)
    , parameters_(parameters)
    , at_plane_(mesh.n_cells, 0)
    , is_emptied_(mesh.n_cells, 0)
    , inverse_volume_(mesh.n_cells, 0.)
    , inverse_mass_(mesh.n_cells, 0.)
  {
    Index n_faces = 0;
    for (const FlatFaces<dim> &faces : mesh.faces)
      {
        n_faces = std::max(n_faces, faces.size());
        for (Index f = 0; f < faces.size(); ++f)
          if (const int side = faces.side[f]; side >= 0 && boundaries[side].kind == BoundaryKind::reflecting)
            at_plane_[faces.cell[1 - (side & 1)][f]] |= 1 << side;
      }
    face_value_.resize(n_faces + 1);
    mass_flux_.resize(n_faces + 1);
    active_.reserve(n_faces);
    kept_cells_.reserve(mesh.n_cells);
    refilled_cells_.reserve(mesh.n_cells);
    cleared_cells_.reserve(mesh.n_cells);
  }

  template <int dim>
  void
  MaterialTransport<dim>::collect_faces(const MaterialState &material, const Index m,
                                        const VolumeFlux<dim> &volume_flux, const SweepTopology<dim> &topology)
  {
    const FlatFaces<dim>      &faces = *topology.faces;
    const std::vector<double> &flux  = volume_flux.flux[m];
    active_.clear();
    for (Index f = 0; f < topology.n_faces; ++f)
      {
        face_value_[f] = 0;
        mass_flux_[f]  = 0;
        if (flux[f] == 0)
          continue;
        const int   side  = flux[f] > 0 ? 0 : 1;
        const Index giver = faces.cell[side][f];
        const Index d     = giver != none ? giver : faces.cell[1 - side][f]; // zero gradient at inflow
        ActiveFace  a{f, d, {d, d}, {d, d}, 0., 0., 1., 1.};
        if (giver != none && parameters_.second_order && volume_flux.is_full(d))
          {
            const auto &up = side ? topology.above : topology.below, &down = side ? topology.below : topology.above;
            const bool  complete = material.volume[up[0][d]] > 0 && material.volume[up[1][d]] > 0 &&
                                  material.volume[down[0][d]] > 0 && material.volume[down[1][d]] > 0;
            if (complete)
              for (int s = 0; s < 2; ++s)
                {
                  a.upstream[s]   = up[s][d];
                  a.downstream[s] = down[s][d];
                }
            a.weight_up   = side ? topology.weight_above[d] : topology.weight_below[d];
            a.weight_down = side ? topology.weight_below[d] : topology.weight_above[d];
            a.volume_kept = 1. - std::abs(flux[f]) / (material.volume[d] * topology.part_share[side][f]);
          }
        active_.push_back(a);
      }
    face_value_[topology.n_faces] = 0;
    mass_flux_[topology.n_faces]  = 0;
  }

  template <int dim>
  void
  MaterialTransport<dim>::collect_cells(const MaterialState &material, const std::vector<double> &flux,
                                        const std::vector<Index> &emptied, const SweepTopology<dim> &topology)
  {
    kept_cells_.clear();
    refilled_cells_.clear();
    cleared_cells_.clear();
    for (const Index c : emptied)
      is_emptied_[c] = 1;
    for (Index c = 0; c < mesh_->n_cells; ++c)
      {
        const double l0 = flux[topology.lower[0][c]], l1 = flux[topology.lower[1][c]];
        const double u0 = flux[topology.upper[0][c]], u1 = flux[topology.upper[1][c]];
        if (l0 == 0 && l1 == 0 && u0 == 0 && u1 == 0)
          continue;
        if (material.volume[c] > 0 && !is_emptied_[c])
          kept_cells_.push_back(c);
        else if (l0 > 0 || l1 > 0 || u0 < 0 || u1 < 0)
          refilled_cells_.push_back(c);
        else
          cleared_cells_.push_back(c);
      }
    for (const Index c : emptied)
      is_emptied_[c] = 0;
  }

  template <int dim>
  void
  MaterialTransport<dim>::face_values(const std::vector<double> &value, double ActiveFace::*const kept)
  {
    for (const ActiveFace &a : active_)
      {
        const double q       = value[a.donor];
        const double up      = q - 0.5 * (value[a.upstream[0]] + value[a.upstream[1]]);
        const double down    = 0.5 * (value[a.downstream[0]] + value[a.downstream[1]]) - q;
        const double central = a.weight_up * up + a.weight_down * down;
        const double curved  = a.weight_up == a.weight_down ? curvature_slope(up, down, a.*kept) : 0.;
        face_value_[a.face]  = q + 0.5 * a.*kept * limited_slope(up, down, central + curved);
      }
  }

  template <int dim>
  void
  MaterialTransport<dim>::odd_face_values(const std::vector<double> &value, double ActiveFace::*const kept,
                                          const int axis)
  {
    const int lower = 1 << (2 * axis), upper = 2 << (2 * axis);
    for (const ActiveFace &a : active_)
      {
        const int planes = at_plane_[a.donor] & (lower | upper);
        // both the donor itself: no slope there
        if (planes == 0 || planes == (lower | upper) || a.upstream[0] == a.downstream[0])
          continue;
        const bool   behind = a.upstream[0] == a.donor; // the plane, else it lies ahead
        const Index *inside = behind ? a.downstream : a.upstream;
        const double q = value[a.donor], difference = 0.5 * (value[inside[0]] + value[inside[1]]) - q;
        const double up = behind ? 2. * q : -difference, down = behind ? difference : -2. * q;
        const double central = a.weight_up * up + a.weight_down * down;
        const double curved  = a.weight_up == a.weight_down ? curvature_slope(up, down, a.*kept) : 0.;
        face_value_[a.face]  = q + 0.5 * a.*kept * limited_slope(up, down, central + curved);
      }
  }

  template <int dim>
  void
  MaterialTransport<dim>::carry(std::vector<double> &value, const std::vector<double> &flux,
                                const std::vector<double> &inverse, const SweepTopology<dim> &topology)
  {
    const double *const fv = face_value_.data(), *const fl = flux.data();
    for (const Index c : kept_cells_)
      {
        const Index  l0 = topology.lower[0][c], l1 = topology.lower[1][c];
        const Index  u0 = topology.upper[0][c], u1 = topology.upper[1][c];
        const double q = value[c];
        const double sum =
            (fl[l0] * (fv[l0] - q) + fl[l1] * (fv[l1] - q)) - (fl[u0] * (fv[u0] - q) + fl[u1] * (fv[u1] - q));
        value[c] = q + sum * inverse[c];
      }
    for (const Index c : refilled_cells_)
      {
        // only what flows in counts; start from the first of it, so that a uniform field stays uniform
        const Index face[4] = {topology.lower[0][c], topology.lower[1][c], topology.upper[0][c], topology.upper[1][c]};
        double      base = 0, sum = 0;
        bool        started = false;
        for (int i = 0; i < 4; ++i)
          if (const double inflow = i < 2 ? fl[face[i]] : -fl[face[i]]; inflow > 0)
            {
              base    = started ? base : fv[face[i]];
              started = true;
              sum += inflow * (fv[face[i]] - base);
            }
        value[c] = base + sum * inverse[c];
      }
    for (const Index c : cleared_cells_)
      value[c] = 0;
  }

  template <int dim>
  void
  MaterialTransport<dim>::update_amounts(MaterialState &material, const std::vector<double> &flux,
                                         const SweepTopology<dim> &topology)
  {
    for (const Index c : kept_cells_)
      {
        material.volume[c] += topology.net(flux, c);
        inverse_volume_[c] = 1. / material.volume[c];
      }
    for (const Index c : refilled_cells_)
      {
        material.volume[c] = (std::max(flux[topology.lower[0][c]], 0.) + std::max(flux[topology.lower[1][c]], 0.)) -
                             (std::min(flux[topology.upper[0][c]], 0.) + std::min(flux[topology.upper[1][c]], 0.));
        inverse_volume_[c] = 1. / material.volume[c];
      }
    for (const Index c : cleared_cells_)
      material.volume[c] = 0;
    carry(material.density, flux, inverse_volume_, topology);
    for (const std::vector<Index> *cells : {&kept_cells_, &refilled_cells_, &cleared_cells_})
      for (const Index c : *cells)
        {
          material.mass[c] = material.density[c] * material.volume[c];
          inverse_mass_[c] = 1. / material.mass[c];
        }
  }

  template <int dim>
  void
  MaterialTransport<dim>::move(MaterialState &material, const Index m, const VolumeFlux<dim> &volume_flux,
                               const SweepTopology<dim> &topology, const std::span<const int> odd_fields,
                               std::vector<double> &mass_flux, RemapSums<dim> &report)
  {
    const std::vector<double> &flux = volume_flux.flux[m];
    collect_faces(material, m, volume_flux, topology);
    if (active_.empty())
      return;
    collect_cells(material, flux, volume_flux.emptied[m], topology);

    // mass of what passes, and its share of the donor's mass: the coordinate in which quantities per mass are linear
    face_values(material.density, &ActiveFace::volume_kept);
    for (ActiveFace &a : active_)
      {
        const double density = face_value_[a.face];
        mass_flux_[a.face]   = flux[a.face] * density;
        mass_flux[a.face] += mass_flux_[a.face];
        a.mass_kept = 1. - (1. - a.volume_kept) * (density / material.density[a.donor]);
      }
    update_amounts(material, flux, topology);

    const auto is_odd = [&](const std::vector<double> &value) {
      return std::any_of(odd_fields.begin(), odd_fields.end(),
                         [&](const int field) { return field >= 0 && &value == &material.fields[field].value; });
    };
    const auto by_volume = [&](std::vector<double> &value) {
      face_values(value, &ActiveFace::volume_kept);
      if (is_odd(value))
        odd_face_values(value, &ActiveFace::volume_kept, topology.axis);
      carry(value, flux, inverse_volume_, topology);
    };
    const auto by_mass = [&](std::vector<double> &value) {
      face_values(value, &ActiveFace::mass_kept);
      carry(value, mass_flux_, inverse_mass_, topology);
    };
    if (material.has_voids())
      by_volume(material.void_fraction);
    for (Field &field : material.fields)
      field.description.carrier == Carrier::volume ? by_volume(field.value) : by_mass(field.value);
    by_mass(material.energy);
    book_boundaries(topology, report);
  }

  template <int dim>
  void
  MaterialTransport<dim>::book_boundaries(const SweepTopology<dim> &topology, RemapSums<dim> &report) const
  {
    const FlatFaces<dim> &faces = *topology.faces;
    for (const Index f : topology.boundary_faces)
      {
        const int upper = faces.side[f] & 1; // the cell lies below an upper side
        if (faces.cell[1 - upper][f] >= mesh_->n_owned)
          continue;
        const double   outwards = upper ? mass_flux_[f] : -mass_flux_[f];
        SideFlux<dim> &side     = report.side[faces.side[f]];
        side.mass += outwards;
        side.internal += outwards * face_value_[f];
      }
  }

  template class MaterialTransport<2>;
} // namespace whipple
