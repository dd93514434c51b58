// SPDX-License-Identifier: LGPL-2.1-or-later
// A flyer across a gap: when the gap closes, and to what state.
#include "field_files.h"
#include "metals.h"
#include "stability_run.h"

#include <cmath>
#include <ostream>

namespace
{
  using namespace whipple;
  using namespace whipple::stability;

  struct Gap
  {
    const char *name;
    double      cells;  ///< width of the gap in cells
    double      offset; ///< of the target's front face from a mesh line, cells
  };

  void
  PrintTo(const Gap &gap, std::ostream *text)
  {
    *text << gap.name;
  }

  class QuickVoidClosure : public testing::TestWithParam<Gap>
  {
  };

  /// Aluminium on aluminium at 2 km/s, without strength. The shock in the target tells when the gap closed:
  /// arrival = t - (position - front) / U_s.
  TEST_P(QuickVoidClosure, ArrivalStateAndFirstPeak)
  {
    const Gap   &gap  = GetParam();
    const double cell = 0.01, speed = 0.2, front = 0.5 + gap.offset * cell, width = gap.cells * cell;
    const double arrival = width / speed, end = arrival + 0.6;
    Case         table("flyer across a gap of " + std::to_string(gap.cells).substr(0, 4) + " cells, target " +
                           std::to_string(gap.offset).substr(0, 4) + " cells off a mesh line",
                       "the gap closes early, late or unnoticed; a spike when it closes", "eulerian");
    SceneText    scene = box("planar", 0, 0, 0.02, 1.3, cell, "transmitting");
    scene.set("Geometry/Right", "reflecting").add("Materials", "metal", {{"Library", "aluminium 2024-T4"}});
    scene.add("Bodies", "flyer", plate(front - width - 0.4, 0.4, "metal", speed))
        .add("Bodies", "target", plate(front, 0.7, "metal"));
    scene.add("Stages", "impact", {{"Mode", "eulerian"}, {"End", with_unit(end, "us")}});
    scene.set("Output/Fields interval", "0.01 us");
    const std::string folder  = std::string("gap_") + gap.name;
    const Outcome     outcome = run(scene, folder);
    expect_sound_impact(table, outcome);
    const Problem<2>     read  = read_problem<2>("stability_output/" + folder + "/scene.prm");
    const ImpedanceMatch match = impedance_match(read.materials[0], read.materials[0], speed);
    const double         shock = match.pressure / (read.materials[0].model.eos->reference_density() * match.velocity);
    const std::vector<Cell> cells    = outcome.cells();
    double                  position = -1, sum = 0, volume = 0;
    for (std::size_t i = 1; i < cells.size(); ++i)
      {
        const Cell &a = cells[i - 1], &b = cells[i];
        if (a.x[1] > front && a.pressure >= 0.5 * match.pressure && b.pressure < 0.5 * match.pressure &&
            b.x[1] > a.x[1])
          position = a.x[1] + (a.pressure - 0.5 * match.pressure) / (a.pressure - b.pressure) * (b.x[1] - a.x[1]);
      }
    for (const Cell &s : cells)
      if (s.x[1] > position - 0.2 && s.x[1] < position - 0.06)
        {
          sum += s.pressure * s.volume;
          volume += s.volume;
        }
    table.at_most("arrival early or late, in times of a cell (cell / velocity)",
                  std::abs(end - (position - front) / shock - arrival) / (cell / speed), 0.5);
    table.within("pressure behind the shock, Mbar", sum / volume, match.pressure, 0.01);
    table.at_most("largest pressure at any time / Hugoniot",
                  largest_in_files(outcome.directory, "pressure") / match.pressure, 1.1);
  }
  INSTANTIATE_TEST_SUITE_P(Gaps, QuickVoidClosure,
                           testing::Values(Gap{"aligned_5", 5., 0.}, Gap{"aligned_1", 1., 0.},
                                           Gap{"off_2_5", 2.5, 0.37}, Gap{"thin_in_one_cell", 0.3, 0.6},
                                           Gap{"thin_across_a_line", 0.5, 0.2}),
                           [](const auto &info) { return std::string(info.param.name); });
} // namespace
