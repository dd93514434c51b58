// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/error.h>
#include <whipple/material/material_library.h>
#include <whipple/scene/command_line.h>

#include <iomanip>
#include <sstream>

namespace whipple::command_line
{
  namespace
  {
    constexpr std::string_view overview =
        R"(Whipple: hypervelocity impact on multi-plate shields, from first contact to the wall.

  whipple run SCENE.prm [options]   run a scene
      -n RANKS                      on that many MPI ranks
      --set 'Section/Name = value'  override an entry of the scene; may be given many times
      --output DIR                  where results go; default output/<name of the scene>
      --validate                    check the scene and stop
  whipple help [TOPIC]              this, or: scene, effects, materials
  whipple --version

The launcher ./whipple in the source tree installs what is missing and builds first, and also knows
  ./whipple build [--debug]         build only
  ./whipple test                    build and run all tests

Exit status: 0 done, 2 the input is wrong, 3 stopped for a physical or numerical reason, 1 anything else.
)";

    constexpr std::string_view scene =
        R"(A scene is one .prm file: geometry, bodies, materials, boundaries, stages, mesh, output.
Every value with a dimension carries its unit ("6.58 km/s", "0.081 cm", "345 MPa"); inside are cm, g, us, Mbar.

  prm/                 scenes to start from
  doc/scene_files.md   every section, entry, unit and default

  whipple run SCENE.prm --validate   says what is wrong with a scene, or that it is fine
  DIR/parameters.prm                 every value that was in force in a run, as a scene that runs again
)";

    constexpr std::string_view effects =
        R"(Effects a scene can switch on; one that is off costs nothing.

  strength    elastic-plastic flow: deviatoric stress with radial return to the yield surface
  voids       pores inside the material: spall, distension and recompaction by a void law
  body tags   which body each gram comes from, carried through all stages
)";

    std::string
    materials()
    {
      std::ostringstream text;
      text << "Materials of the library (density g/cm^3, yield stress Mbar, source):\n\n";
      for (const MaterialConstants &material : material_library())
        {
          text << "  " << std::left << std::setw(26) << material.name << std::setw(9) << material.density
               << std::setw(9) << material.yield_stress << material.source << '\n';
          if (!material.caution.empty())
            text << std::setw(46) << "" << material.caution << '\n';
        }
      return text.str();
    }
  } // namespace

  std::string
  help(std::string_view topic)
  {
    if (topic.empty())
      return std::string(overview);
    if (topic == "scene")
      return std::string(scene);
    if (topic == "effects")
      return std::string(effects);
    if (topic == "materials")
      return materials();
    throw InputError("no help on '" + std::string(topic) + "': topics are scene, effects, materials");
  }
} // namespace whipple::command_line
