// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/diagnostics/body_share.h>
#include <whipple/diagnostics/free_surface.h>

#include <algorithm>

namespace whipple
{
  namespace
  {
    /// Share of a cell from which a body is a surface and not a splinter before it.
    constexpr double least_share = 0.5;

    template <int dim>
    double
    filled_by(const MeasureView<dim> &view, std::size_t body, Index c)
    {
      const MaterialState &m = view.state.material[view.layout.body_material[body]];
      if (!(m.volume[c] > 0))
        return 0;
      return m.volume[c] / view.state.volume[c] * share_of_body(view.scene, view.layout, body, m, c);
    }

    template <int dim>
    double
    filled(const MeasureView<dim> &view, Index c)
    {
      double volume = 0;
      for (const MaterialState &m : view.state.material)
        volume += m.volume[c];
      return std::min(volume / view.state.volume[c], 1.);
    }

    /// Cells along the lower side of axis 0.
    template <int dim>
    bool
    is_at_side(const FlatMesh<dim> &mesh, Index c)
    {
      return key_point<dim>(mesh.key[c])[0] == 0;
    }

    /// Length along the line of flight of what stands in the cell beyond c, if that is not a surface itself.
    template <int dim>
    double
    length_beyond(const MeasureView<dim> &view, std::size_t body, bool rear, Index c)
    {
      const FlatMesh<dim> &mesh    = view.mesh;
      const auto           begin   = [&](Index i) { return key_point<dim>(mesh.key[i])[flight_axis<dim>]; };
      const auto           end     = [&](Index i) { return begin(i) + view.scene.lattice.extent(mesh.level[i]); };
      const auto           touches = [&](Index i) { return rear ? begin(i) == end(c) : end(i) == begin(c); };
      for (Index i = 0; i < mesh.n_cells; ++i)
        if (is_at_side(mesh, i) && touches(i))
          return filled_by(view, body, i) * mesh.size[i];
      return 0;
    }
  } // namespace

  template <int dim>
  SurfacePoint<dim>
  find_surface(const MeasureView<dim> &view, std::size_t body, bool rear)
  {
    const FlatMesh<dim> &mesh   = view.mesh;
    const bool           moving = view.scene.stages[view.stage].mode() == StageMode::lagrangian;
    SurfacePoint<dim>    outermost;
    for (Index c = 0; c < mesh.n_owned; ++c)
      {
        if (!is_at_side(mesh, c) || filled_by(view, body, c) < least_share)
          continue;
        SurfacePoint<dim> surface;
        surface.point.cell = c;
        surface.point.local[flight_axis<dim>] =
            moving ? (rear ? 1. : 0.) : (rear ? filled(view, c) : 1. - filled(view, c));
        surface.position = at_point<dim>(mesh, view.state.position, surface.point)[flight_axis<dim>];
        if (outermost.point.cell == none ||
            (rear ? surface.position > outermost.position : surface.position < outermost.position))
          outermost = surface;
      }
    if (outermost.point.cell != none && !moving)
      outermost.position += (rear ? 1. : -1.) * length_beyond(view, body, rear, outermost.point.cell);
    return outermost;
  }

  template SurfacePoint<2>
  find_surface(const MeasureView<2> &, std::size_t, bool);
} // namespace whipple
