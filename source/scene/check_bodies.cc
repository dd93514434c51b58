// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/sections.h>

#include <cmath>
#include <sstream>

namespace whipple::sections
{
  namespace
  {
    /// Distance by which a body may reach outside the domain and still count as inside, relative to the domain.
    constexpr double touching = 1e-12;

    /// The key that says where a body is.
    template <int dim>
    std::string
    position_key(const Shape<dim> &shape)
    {
      if (std::holds_alternative<Sphere<dim>>(shape))
        return "Center";
      return std::holds_alternative<Plate<dim>>(shape) ? "Front face" : "Lower corner";
    }

    /// The key that says how large a body is.
    template <int dim>
    std::string
    size_key(const Shape<dim> &shape)
    {
      if (std::holds_alternative<Sphere<dim>>(shape))
        return "Diameter";
      return std::holds_alternative<Plate<dim>>(shape) ? "Thickness" : "Upper corner";
    }

    /// Whether the part of the body below axis 0 = 0 is the mirror image of the part above.
    template <int dim>
    bool
    symmetric_about_axis(const Shape<dim> &shape)
    {
      const Box<dim> box = extent(shape);
      return box.lower[0] == -box.upper[0];
    }

    /// "0 cm to 4.096 cm", rounded for reading.
    template <int dim>
    std::string
    range(const Box<dim> &box, int axis)
    {
      std::ostringstream text;
      text << box.lower[axis] << " cm to " << box.upper[axis] << " cm";
      return text.str();
    }

    template <int dim>
    void
    check_inside_domain(const SceneSection &section, const Body<dim> &body, const Scene<dim> &scene)
    {
      Box<dim>          box   = extent(body.shape);
      const Vector<dim> lower = scene.lattice.origin, upper = scene.upper_corner();
      const bool        mirror = lower[0] == 0 && scene.boundaries[0].kind == BoundaryKind::reflecting;
      if (mirror && symmetric_about_axis(body.shape))
        box.lower[0] = 0;
      for (int d = 0; d < dim; ++d)
        {
          const double slack = touching * (upper[d] - lower[d]);
          if ((std::isfinite(box.lower[d]) && box.lower[d] < lower[d] - slack) ||
              (std::isfinite(box.upper[d]) && box.upper[d] > upper[d] + slack))
            section.reject(position_key(body.shape), "the body reaches over " + range(box, d) + " along axis " +
                                                         std::to_string(d) + "; allowed is the domain, " +
                                                         range(Box<dim>{lower, upper}, d));
        }
    }

    /// A body that is a speck of one cell has a mass and no shape: cells or body are given in another unit than meant.
    template <int dim>
    void
    check_size(const SceneSection &section, const Body<dim> &body, const Scene<dim> &scene)
    {
      constexpr double smallest = 2e-6; // cells: what is thinner is a trace (doc/theory/traces.md)
      const Box<dim>   box      = extent(body.shape);
      for (int d = 0; d < dim; ++d)
        if (!(box.upper[d] - box.lower[d] >= smallest * scene.lattice.spacing))
          {
            std::ostringstream text;
            text << "the body is " << box.upper[d] - box.lower[d] << " cm thick along axis " << d
                 << " and the finest cell " << scene.lattice.spacing << " cm; allowed is a body of at least "
                 << smallest << " cells";
            section.reject(size_key(body.shape), text.str());
          }
    }

    template <int dim>
    void
    check_axisymmetric(const SceneSection &section, const Body<dim> &body)
    {
      const auto *sphere = std::get_if<Sphere<dim>>(&body.shape);
      if (sphere && sphere->center[0] != 0)
        section.reject("Center", "in axisymmetry a sphere sits on the axis; its first component must be 0 cm");
      if (body.velocity[0] != 0 && extent(body.shape).lower[0] <= 0)
        section.reject("Velocity", "in axisymmetry a body on the axis moves along it; the first component must be 0");
    }

    template <int dim>
    void
    check_deposit(const SceneSection &section, const Body<dim> &body)
    {
      const Box<dim> box = extent(body.shape);
      for (int d = 0; d < dim; ++d)
        if (body.deposit->point[d] < box.lower[d] || body.deposit->point[d] > box.upper[d])
          section.reject("Deposit point", "must lie in the body");
    }
  } // namespace

  template <int dim>
  void
  check_bodies(SceneParameters &parameters, const Scene<dim> &scene)
  {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      {
        const Body<dim>   &body = scene.bodies[b];
        const SceneSection section(parameters, "Bodies/" + body.name);
        if (scene.lattice.symmetry == Symmetry::axisymmetric)
          check_axisymmetric(section, body);
        check_inside_domain(section, body, scene);
        check_size(section, body, scene);
        if (body.deposit)
          check_deposit(section, body);
        for (std::size_t other = 0; other < b; ++other)
          if (overlap(body.shape, scene.bodies[other].shape))
            section.reject(position_key(body.shape),
                           "overlaps the body '" + scene.bodies[other].name + "'; bodies may touch but not overlap");
      }
  }

  template void
  check_bodies(SceneParameters &, const Scene<2> &);
} // namespace whipple::sections
