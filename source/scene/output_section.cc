// SPDX-License-Identifier: LGPL-2.1-or-later
#include <whipple/scene/sections.h>

namespace whipple::sections
{
  namespace
  {
    const std::string path = "Output";
  } // namespace

  void
  declare_output(SceneParameters &parameters)
  {
    SceneSection section(parameters, path);
    section.declare("Fields interval", "none", "none | time between field files; each stage also writes its end");
    section.declare("Formats", "hdf5", "of the field files: hdf5 (with XDMF), vtu, or both");
    section.declare("Statistics interval", "0 us", "time between lines of statistics.csv; 0 us: every step");
    section.declare("Error estimate", "none",
                    "none | 2 | 3 | 4: cell sizes (own, twice, four times ...) that error bars are taken from");
  }

  OutputControl
  read_output(SceneParameters &parameters)
  {
    const SceneSection section(parameters, path);
    OutputControl      output;
    output.fields_interval     = section.optional_positive("Fields interval", units::time);
    output.statistics_interval = section.non_negative("Statistics interval", units::time);
    if (section.text("Error estimate") != "none")
      output.error_estimate_levels = section.integer("Error estimate", 2, 4);
    output.hdf5 = false;
    for (const std::string &format : section.list("Formats"))
      (section.name_index("Formats", format, {"hdf5", "vtu"}) == 0 ? output.hdf5 : output.vtu) = true;
    return output;
  }
} // namespace whipple::sections
