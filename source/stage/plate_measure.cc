// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/stage/plate_measure.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace whipple
{
  namespace
  {
    /// Solid volume fraction of a plate's material on the finest lattice inside the plate's original box.
    struct PlateImage
    {
      int                 columns = 0, rows = 0; ///< along axis 0, along axis 1
      double              spacing = 0;           ///< cm
      std::vector<double> solid;                 ///< [row * columns + column]

      double
      at(int row, int column) const
      {
        return solid[static_cast<std::size_t>(row) * columns + column];
      }

      double
      hole_radius(int row) const
      {
        for (int i = columns - 1; i >= 0; --i)
          if (at(row, i) < 0.5)
            return spacing * (i + 1 - std::min(at(row, i), 1.));
        return 0;
      }
    };

    /// Solid fraction that a body contributes to a cell.
    template <int dim>
    double
    solid_of_body(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const State<dim> &state,
                  Index c)
    {
      const Index          material = layout.body_material[body];
      const MaterialState &m        = state.material[material];
      if (m.mass[c] == 0.)
        return 0;
      double share = 1.;
      if (layout.body_tag[body] >= 0)
        share = m.fields[layout.body_tag[body]].value[c];
      else
        for (std::size_t b = 0; b < scene.bodies.size(); ++b)
          if (layout.body_material[b] == material && layout.body_tag[b] >= 0)
            share -= m.fields[layout.body_tag[b]].value[c];
      const double solid = m.has_voids() ? 1. - m.void_fraction[c] : 1.;
      return share * solid * m.volume[c] / state.volume[c];
    }

    template <int dim>
    PlateImage
    plate_image(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const FlatMesh<dim> &mesh,
                const State<dim> &state, MPI_Comm communicator)
    {
      const Lattice<dim> &lattice = scene.lattice;
      const Box<dim>      box     = extent(scene.bodies[body].shape);
      const int           columns =
          std::min<double>(lattice.finest(0), std::ceil((box.upper[0] - lattice.origin[0]) / lattice.spacing));
      const int  first = static_cast<int>(std::floor((box.lower[1] - lattice.origin[1]) / lattice.spacing + 1e-6));
      const int  last  = static_cast<int>(std::ceil((box.upper[1] - lattice.origin[1]) / lattice.spacing - 1e-6));
      PlateImage image{columns, last - first, lattice.spacing, {}};
      image.solid.assign(static_cast<std::size_t>(image.rows) * columns, 0.);
      for (Index c = 0; c < mesh.n_owned; ++c)
        {
          const LatticePoint<dim> p    = key_point<dim>(mesh.key[c]);
          const int               size = lattice.extent(mesh.level[c]);
          if (p[1] >= last || p[1] + size <= first || p[0] >= columns)
            continue;
          const double solid = solid_of_body(scene, layout, body, state, c);
          for (int j = std::max(p[1], first); j < std::min(p[1] + size, last); ++j)
            for (int i = p[0]; i < std::min(p[0] + size, columns); ++i)
              image.solid[static_cast<std::size_t>(j - first) * columns + i] = solid;
        }
      MPI_Allreduce(MPI_IN_PLACE, image.solid.data(), static_cast<int>(image.solid.size()), MPI_DOUBLE, MPI_SUM,
                    communicator);
      return image;
    }
  } // namespace

  template <int dim>
  PlateMeasure
  measure_plate(const Scene<dim> &scene, const FieldLayout &layout, std::size_t body, const FlatMesh<dim> &mesh,
                const State<dim> &state, MPI_Comm communicator)
  {
    if (!std::holds_alternative<Plate<dim>>(scene.bodies[body].shape))
      throw Error("body '" + scene.bodies[body].name + "' is no plate and has no hole to measure");
    const PlateImage image = plate_image(scene, layout, body, mesh, state, communicator);
    PlateMeasure     result;
    result.hole_diameter          = image.hole_radius((image.rows - 1) / 2) + image.hole_radius(image.rows / 2);
    result.smallest_hole_diameter = 2. * image.hole_radius(0);
    for (int row = 1; row < image.rows; ++row)
      result.smallest_hole_diameter = std::min(result.smallest_hole_diameter, 2. * image.hole_radius(row));
    result.least_thickness = image.rows * image.spacing;
    for (int column = 0; column < image.columns; ++column)
      {
        double thickness = 0;
        int    front     = image.rows; // first half-solid layer
        for (int row = image.rows - 1; row >= 0; --row)
          {
            thickness += image.at(row, column) * image.spacing;
            if (image.at(row, column) >= 0.5)
              front = row;
          }
        result.perforated      = result.perforated || front == image.rows;
        result.crater_depth    = std::max(result.crater_depth, front * image.spacing);
        result.least_thickness = std::min(result.least_thickness, thickness);
      }
    return result;
  }

  template PlateMeasure
  measure_plate(const Scene<2> &, const FieldLayout &, std::size_t, const FlatMesh<2> &, const State<2> &, MPI_Comm);
} // namespace whipple
