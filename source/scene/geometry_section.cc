// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/sections.h>

#include <array>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Geometry";

    /// Names of the sides, ordered 2 * axis + upper.
    const std::array<std::string, 4> sides{{"Left", "Right", "Bottom", "Top"}};

    /// "reflecting", "transmitting", or "inflow V0, V1" with a velocity.
    template <int dim>
    Boundary<dim>
    read_boundary(const SceneSection &section, const std::string &side)
    {
      const std::string text = section.text(side);
      if (text == "reflecting")
        return {BoundaryKind::reflecting, {}};
      if (text == "transmitting")
        return {BoundaryKind::transmitting, {}};
      const std::optional<std::string> velocity = text_after("inflow", text);
      if (!velocity)
        section.reject(side, "allowed are reflecting, transmitting, and inflow with a velocity such as "
                             "'inflow 0 cm/us, 0.01 cm/us'");
      return {BoundaryKind::inflow, section.parse_vector<dim>(side, *velocity, units::velocity)};
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
    section.declare("Left", "reflecting",
                    "reflecting | transmitting | inflow VELOCITY, VELOCITY; the axis in axisymmetry is reflecting");
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
      scene.boundaries[side] = read_boundary<dim>(section, sides[side]);

    if (scene.lattice.symmetry == Symmetry::axisymmetric)
      {
        if (scene.lattice.origin[0] != 0)
          section.reject("Lower corner", "in axisymmetry the left side is the axis; its first component must be 0 cm");
        if (scene.boundaries[0].kind != BoundaryKind::reflecting)
          section.reject("Left", "in axisymmetry the left side is the axis; allowed is reflecting");
      }
    return upper;
  }

  template Vector<2>
  read_geometry<2>(SceneParameters &, Scene<2> &);
} // namespace whipple::sections
