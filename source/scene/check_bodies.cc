// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/sections.h>
#include <whipple/scene/shape_section.h>

#include <cmath>
#include <sstream>

namespace whipple::sections
{
  namespace
  {
    /// Distance by which a body may reach outside the domain and still count as inside, relative to the domain.
    constexpr double touching = 1e-12;

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
      if (mirror && body.shape->is_mirrored())
        box.lower[0] = 0;
      for (int d = 0; d < dim; ++d)
        {
          const double slack = touching * (upper[d] - lower[d]);
          if ((std::isfinite(box.lower[d]) && box.lower[d] < lower[d] - slack) ||
              (std::isfinite(box.upper[d]) && box.upper[d] > upper[d] + slack))
            section.reject(shape_description(section).position_key,
                           "the body reaches over " + range(box, d) + " along axis " + std::to_string(d) +
                               "; allowed is the domain, " + range(Box<dim>{lower, upper}, d));
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
            section.reject(shape_description(section).size_key, text.str());
          }
      if (const double thin = body.shape->least_thickness({}); !(thin >= smallest * scene.lattice.spacing))
        {
          std::ostringstream text;
          text << "the body is " << thin << " cm thin and the finest cell " << scene.lattice.spacing
               << " cm; allowed is a body of at least " << smallest << " cells";
          section.reject(shape_description(section).size_key, text.str());
        }
    }

    template <int dim>
    void
    check_axisymmetric(const SceneSection &section, const Body<dim> &body)
    {
      if (body.is_uniform() && body.velocity[0] != 0 && extent(body.shape).lower[0] <= 0)
        section.reject("Velocity", "in axisymmetry a body on the axis moves along it; the first component must be 0");
    }

    template <int dim>
    void
    check_deposit(const SceneSection &section, const Body<dim> &body)
    {
      if (!body.shape->contains(body.deposit->point))
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
            section.reject(shape_description(section).position_key,
                           "overlaps the body '" + scene.bodies[other].name + "'; bodies may touch but not overlap");
      }
  }

  template void
  check_bodies(SceneParameters &, const Scene<2> &);
} // namespace whipple::sections
