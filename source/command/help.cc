// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/command/command_line.h>
#include <whipple/command/model_reference.h>
#include <whipple/command/shape_reference.h>
#include <whipple/error.h>
#include <whipple/exact/exact_factory.h>
#include <whipple/material/material_library.h>
#include <whipple/scene/units.h>

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
      --effects-report              say which effects matter in the scene, and stop
  whipple run --resume DIR          go on with a run that was stopped; takes -n and --set for what may change
  whipple study STUDY.prm [options] run a scene many times: errors, orders, error bars, and what they cost
      -n, --set, --output, --validate as above
      --tolerance 'RESULT = 2 %'    find and run the cheapest setting that is so accurate
      --budget '20 min'             if it does not take longer than this
      --any-version                 also reuse points that another version of the program has computed
  whipple help [TOPIC]              this, or: scene, study, shapes, effects, models, materials,
                                    exact solutions
  whipple --version

The launcher ./whipple in the source tree installs what is missing and builds first, and also knows
  ./whipple build [--debug]         build only
  ./whipple test                    build and run all tests
  ./whipple plot DIR                pictures of a run or a study

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

    constexpr std::string_view study =
        R"(A study runs a scene with finer and finer cells, and with other choices, each point in a directory of its own, and
says how wrong each result is and what a better one costs. Points that are there already are not run again.

  subsection Study                  in the scene itself, or in a file that says: set Scene = SCENE.prm
    set Axes = cell, refinement
    subsection cell
      set Parameter = Mesh/Finest cell
      set Values    = 0.016 cm | 0.008 cm | 0.004 cm
    end
    subsection refinement
      set Parameter = Mesh/Refinement
      set Values    = adaptive | uniform
    end
  end

  whipple study STUDY.prm --validate    check every point and list them
  whipple study SCENE.prm --tolerance 'bumper hole diameter = 2 %' --budget '20 min'
  DIR/study.md, study.csv, study.json   tables to read, a row a point, everything
  doc/studies.md                        the format, and how orders and error bars are found
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
      text << "\nMaterials that only some models have constants of (whipple help models):\n\n ";
      for (const std::string &name : material_names())
        if (!find_in_library(name))
          text << "  " << name;
      text << '\n';
      return text.str();
    }

    std::string
    exact_solutions()
    {
      std::ostringstream text;
      text << "Exact solutions a scene can be measured against (Exact solution/Name), and their constants:\n";
      for (const exact::ExactKind &kind : exact::exact_kinds<2>())
        {
          text << "\n  " << kind.name << ": " << kind.description << '\n';
          for (const exact::ExactConstant &constant : kind.constants)
            {
              const units::Quantity *quantity = units::find_quantity(constant.quantity);
              text << "      " << std::left << std::setw(26) << constant.key << std::setw(18)
                   << (quantity ? units::format(constant.default_value, *quantity) : "") << constant.documentation
                   << '\n';
            }
        }
      return text.str();
    }
  } // namespace

  std::string
  help(std::string_view topic)
  {
    if (topic.empty() || topic == "run")
      return std::string(overview);
    if (topic == "scene")
      return std::string(scene);
    if (topic == "study")
      return std::string(study);
    if (topic == "shapes")
      return shape_reference();
    if (topic == "effects")
      return model_reference::overview();
    if (topic == "models")
      return model_reference::markdown();
    if (topic == "materials")
      return materials();
    if (topic == "exact solutions")
      return exact_solutions();
    throw InputError("no help on '" + std::string(topic) +
                     "': topics are scene, study, shapes, effects, models, materials, exact solutions");
  }
} // namespace whipple::command_line
