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
    section.declare("History interval", "0.1 us",
                    "none | time between lines of history.csv, results against time as if the stage ended there");
    section.declare("Checkpoint interval", "10 min",
                    "none | wall time between checkpoints; each stage also ends with one (whipple run --resume DIR)");
    section.declare("Wall time limit", "none",
                    "none | wall time after which the run stops with a checkpoint, exit status 3");
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
    output.history_interval    = section.optional_positive("History interval", units::time);
    const auto seconds         = [](std::optional<double> us) { return us ? std::optional<double>(1e-6 * *us) : us; };
    output.checkpoint_interval = seconds(section.optional_positive("Checkpoint interval", units::time));
    output.wall_time_limit     = seconds(section.optional_positive("Wall time limit", units::time));
    if (section.text("Error estimate") != "none")
      output.error_estimate_levels = section.integer("Error estimate", 2, 4);
    output.hdf5 = false;
    for (const std::string &format : section.list("Formats"))
      (section.name_index("Formats", format, {"hdf5", "vtu"}) == 0 ? output.hdf5 : output.vtu) = true;
    return output;
  }
} // namespace whipple::sections
