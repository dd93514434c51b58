// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/sections.h>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Output";

    /// Exact solutions a scene can be measured against.
    const std::vector<std::string> exact_solutions{"sod", "sedov", "plate impact", "elastic-plastic piston",
                                                   "translation"};
  } // namespace

  void
  declare_output(SceneParameters &parameters)
  {
    SceneSection section(parameters, path);
    section.declare("Fields interval", "none", "none | time between field files; each stage also writes its end");
    section.declare("Formats", "hdf5", "of the field files: hdf5 (with XDMF), vtu, or both");
    section.declare("Statistics interval", "0 us", "time between lines of statistics.csv; 0 us: every step");
    section.declare("Exact solution", "none",
                    "none | sod | sedov | plate impact | elastic-plastic piston | translation");
  }

  OutputControl
  read_output(SceneParameters &parameters)
  {
    const SceneSection section(parameters, path);
    OutputControl      output;
    output.fields_interval     = section.optional_positive("Fields interval", units::time);
    output.statistics_interval = section.non_negative("Statistics interval", units::time);
    output.hdf5                = false;
    for (const std::string &format : section.list("Formats"))
      (section.name_index("Formats", format, {"hdf5", "vtu"}) == 0 ? output.hdf5 : output.vtu) = true;
    return output;
  }

  std::optional<std::string>
  read_exact_solution(SceneParameters &parameters)
  {
    const SceneSection section(parameters, path);
    const std::string  name = section.text("Exact solution");
    if (name == "none")
      return std::nullopt;
    return exact_solutions[section.name_index("Exact solution", name, exact_solutions)];
  }
} // namespace whipple::sections
