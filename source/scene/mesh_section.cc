// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/refinement/refinement_criterion.h>
#include <whipple/scene/sections.h>

#include <cmath>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Mesh";

    /// Cell keys hold 19 bits a coordinate (make_key).
    constexpr double max_cells_along_axis = 1 << 19;
    constexpr int    max_levels           = 12;

    /// Root cells that cover a length; a length that misses a whole number by round-off of its decimal digits
    /// counts as that number.
    int
    roots_over(double length, double root)
    {
      const double roots = length / root, nearest = std::round(roots);
      return static_cast<int>(std::abs(roots - nearest) < 1e-9 * roots && nearest > 0 ? nearest : std::ceil(roots));
    }
  } // namespace

  void
  declare_mesh(SceneParameters &parameters)
  {
    SceneSection section(parameters, path);
    section.declare("Finest cell", "", "edge of the finest cells");
    section.declare("Levels", "5", "refinement levels below the root cells: root cell = finest cell * 2^levels");
    section.declare("Refinement", "adaptive",
                    "adaptive: follows the material; uniform: finest cells everywhere; region: finest in a fixed box");
    section.declare("Buffer", "8", "finest cells kept around material that needs the finest level");
    section.declare("Regrid interval", "10", "steps between regrids");
    section.declare("Distended threshold", "0.1",
                    "solid volume fraction of a cell below which it gives up one level of refinement");
    section.declare("Distended ratio", "0.25", "and one level more for each factor of this below the threshold");
    section.declare("Quiet levels", "2", "levels that solid material gives up where nothing has reached it yet");
    section.declare("Quiet velocity", "1 m/s", "velocity, and stress over impedance, below which nothing has");
    for (const auto &[name, criterion] : RefinementCriteria::all())
      for (const SectionEntry &entry : criterion.entries)
        section.declare(entry.key, entry.default_value, entry.documentation);
    section.declare("Region", "", "with Refinement = region: 'lower corner, upper corner' of the box of finest cells");
    section.declare("Region levels", "1", "with Refinement = region: levels that cells outside the box give up");
  }

  namespace
  {
    /// The box of finest cells of Refinement::region.
    void
    read_region(const SceneSection &section, MeshControl &mesh, int max_level)
    {
      if (mesh.refinement != Refinement::region)
        {
          if (section.given("Region"))
            section.reject("Region", "needs Refinement = region");
          return;
        }
      if (!section.given("Region"))
        section.reject("Region", "must be given with Refinement = region, for example '0 cm, 0 cm, 1 cm, 2 cm'");
      const auto corners = section.vector<4>("Region", units::length);
      mesh.region        = {{{corners[0], corners[1]}}, {{corners[2], corners[3]}}};
      for (int d = 0; d < 2; ++d)
        if (!(mesh.region.upper[d] > mesh.region.lower[d]))
          section.reject("Region", "the upper corner (last two) must lie above the lower corner (first two)");
      mesh.region_levels = section.integer("Region levels", 0, max_level);
    }
  } // namespace

  template <int dim>
  void
  read_mesh(SceneParameters &parameters, const Vector<dim> &upper, Scene<dim> &scene)
  {
    const SceneSection section(parameters, path), geometry(parameters, "Geometry");
    Lattice<dim>      &lattice = scene.lattice;
    lattice.spacing            = section.positive("Finest cell", units::length);
    lattice.max_level          = section.integer("Levels", 0, max_levels);

    bool grown = false;
    for (int d = 0; d < dim; ++d)
      {
        const double length = upper[d] - lattice.origin[d];
        if (!(length / lattice.spacing < max_cells_along_axis / 2))
          section.reject("Finest cell", "too fine for the domain; allowed are at most " + std::to_string(1 << 18) +
                                            " finest cells along an axis");
        lattice.roots[d] = roots_over(length, lattice.spacing * lattice.extent(0));
        if (!(lattice.finest(d) < max_cells_along_axis))
          section.reject("Levels", "root cells larger than the domain; allowed are fewer levels");
        grown = grown || std::abs(scene.upper_corner()[d] - upper[d]) > 1e-9 * length;
      }
    if (grown)
      {
        std::string corner;
        for (int d = 0; d < dim; ++d)
          corner += (d ? ", " : "") + units::format(scene.upper_corner()[d], units::length);
        geometry.replace("Upper corner", corner);
      }

    scene.mesh.refinement = section.choice<Refinement>(
        "Refinement",
        {{"adaptive", Refinement::adaptive}, {"uniform", Refinement::uniform}, {"region", Refinement::region}});
    scene.mesh.buffer         = section.integer("Buffer", 1, 64);
    scene.mesh.regrid_steps   = section.integer("Regrid interval", 1, 1000);
    scene.mesh.solid_fraction = section.between("Distended threshold", units::number, 0, 1);
    scene.mesh.solid_ratio    = section.between("Distended ratio", units::number, 1e-3, 0.9);
    scene.mesh.quiet_levels   = section.integer("Quiet levels", 0, max_levels);
    scene.mesh.quiet_velocity = section.positive("Quiet velocity", units::velocity);
    const SectionInput input  = section.input();
    for (const auto &[name, criterion] : RefinementCriteria::all())
      if (auto read = criterion.read(input))
        scene.mesh.criteria.push_back(std::move(read));
    read_region(section, scene.mesh, lattice.max_level);
  }

  template void
  read_mesh<2>(SceneParameters &, const Vector<2> &, Scene<2> &);
} // namespace whipple::sections
