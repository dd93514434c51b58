// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/plausible.h>
#include <whipple/scene/sections.h>

#include <algorithm>
#include <numbers>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Geometry";

    /// Kinds of sides that need no value.
    const std::vector<std::pair<std::string, BoundaryKind>> words{{"reflecting", BoundaryKind::reflecting},
                                                                  {"transmitting", BoundaryKind::transmitting},
                                                                  {"keep velocity", BoundaryKind::keep_velocity},
                                                                  {"exact", BoundaryKind::exact}};

    /// A word, "inflow V0, V1" with a velocity, or "pressure P".
    template <int dim>
    Boundary<dim>
    read_boundary(const SceneSection &section, const std::string &side)
    {
      const std::string text = section.text(side);
      Boundary<dim>     boundary;
      for (const auto &[word, kind] : words)
        if (text == word)
          {
            boundary.kind = kind;
            return boundary;
          }
      if (text == "transmitting, keeps ambient stress")
        boundary.keeps_ambient = true; // of which the bodies tell later
      else if (const auto velocity = text_after("inflow", text))
        {
          boundary.kind     = BoundaryKind::inflow;
          boundary.velocity = section.parse_vector<dim>(side, *velocity, units::velocity);
        }
      else if (const auto pressure = text_after("pressure", text))
        {
          boundary.kind     = BoundaryKind::pressure;
          boundary.pressure = plausible::pressure(section, side, *pressure);
        }
      else
        section.reject(side, "allowed are reflecting, transmitting, 'transmitting, keeps ambient stress', keep "
                             "velocity, exact, inflow with a velocity such as 'inflow 0 cm/us, 0.01 cm/us', and "
                             "pressure with a value such as 'pressure 1 MPa'");
      return boundary;
    }
    /// Axis 0 of a polar lattice is a radius, whose sides are arcs; the upper side of axis 1 is the axis of (r, z).
    template <int dim>
    void
    read_polar_sides(const SceneSection &section, Scene<dim> &scene)
    {
      if (!(scene.lattice.origin[0] >= 0))
        section.reject("Lower corner", "on a polar mesh the first component is a radius; allowed is >= 0 cm");
      for (const int arc : {0, 1})
        if (scene.boundaries[arc].kind == BoundaryKind::reflecting ||
            scene.boundaries[arc].kind == BoundaryKind::transmitting)
          section.reject(side_names[arc], "on a polar mesh this side is an arc; allowed are inflow, pressure, keep "
                                          "velocity and exact");
      if (scene.lattice.symmetry == Symmetry::axisymmetric && scene.boundaries[3].kind != BoundaryKind::reflecting)
        section.reject("Top", "on a polar mesh the upper side is the axis; allowed is reflecting");
      scene.boundaries[3].turned_axis = 0;
    }
  } // namespace

  void
  declare_geometry(SceneParameters &parameters)
  {
    SceneSection section(parameters, path);
    section.declare("Symmetry", "axisymmetric",
                    "axisymmetric: axis 0 is the radius r, axis 1 is z; planar: x and y, 1 cm deep");
    section.declare("Lower corner", "", "of the domain: 'r, z' or 'x, y'");
    section.declare("Upper corner", "", "of the domain; grows to the next whole number of root cells");
    section.declare("Mesh map", "none",
                    "none | saltzman (sheared along the longer axis) | polar (axis 0: radius, axis 1: angle, "
                    "equator to axis); moving meshes only");
    section.declare("Left", "reflecting",
                    "reflecting | transmitting | transmitting, keeps ambient stress | inflow VELOCITY, VELOCITY | "
                    "pressure PRESSURE | keep velocity | exact; the axis in axisymmetry is reflecting");
    section.declare("Right", "transmitting", "as Left");
    section.declare("Bottom", "transmitting", "as Left");
    section.declare("Top", "transmitting", "as Left");
  }

  template <int dim>
  Vector<dim>
  read_geometry(SceneParameters &parameters, Scene<dim> &scene)
  {
    const SceneSection section(parameters, path);
    scene.lattice.symmetry =
        section.choice<Symmetry>("Symmetry", {{"axisymmetric", Symmetry::axisymmetric}, {"planar", Symmetry::planar}});
    scene.lattice.origin    = section.vector<dim>("Lower corner", units::length);
    const Vector<dim> upper = section.vector<dim>("Upper corner", units::length);
    for (int d = 0; d < dim; ++d)
      if (!(upper[d] > scene.lattice.origin[d]))
        section.reject("Upper corner",
                       "must lie above the lower corner '" + section.text("Lower corner") + "' along every axis");
    for (int side = 0; side < 2 * dim; ++side)
      scene.boundaries[side] = read_boundary<dim>(section, side_names[side]);

    scene.mesh_map = section.choice<MeshMap>(
        "Mesh map", {{"none", MeshMap::identity}, {"saltzman", MeshMap::saltzman}, {"polar", MeshMap::polar}});
    if (scene.mesh_map == MeshMap::polar)
      {
        read_polar_sides<dim>(section, scene);
        return upper;
      }
    if (scene.lattice.symmetry == Symmetry::axisymmetric)
      {
        if (scene.lattice.origin[0] != 0)
          section.reject("Lower corner", "in axisymmetry the left side is the axis; its first component must be 0 cm");
        if (scene.boundaries[0].kind != BoundaryKind::reflecting)
          section.reject("Left", "in axisymmetry the left side is the axis; allowed is reflecting");
      }
    return upper;
  }

  template <int dim>
  void
  check_mesh_map(SceneParameters &parameters, const Scene<dim> &scene)
  {
    if (scene.mesh_map == MeshMap::identity)
      return;
    const SceneSection section(parameters, path);
    for (const Stage &stage : scene.stages)
      if (!stage.lagrangian || stage.lagrangian->cohesion != Cohesion::bonded)
        section.reject("Mesh map", "stage '" + stage.name +
                                       "' has no bonded moving mesh; allowed are maps where all "
                                       "stages are lagrangian and bonded");
    const double a = scene.upper_corner()[0] - scene.lattice.origin[0];
    const double b = scene.upper_corner()[1] - scene.lattice.origin[1];
    if (scene.mesh_map == MeshMap::saltzman && !(std::numbers::pi * std::min(a, b) < std::max(a, b)))
      section.reject("Mesh map", "folds the mesh; allowed are domains more than pi times as long as wide");
  }

  template void
  check_mesh_map(SceneParameters &, const Scene<2> &);
  template Vector<2>
  read_geometry<2>(SceneParameters &, Scene<2> &);
} // namespace whipple::sections
