#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the four-bumper case and write doc/multi_plate.md: Table 1 of the paper of 1993, ours beside it.

    scripts/table_1.py BUILD_DIRECTORY [--cells 0.016 0.008] [--keep DIRECTORY]

A run that is in DIRECTORY already, and completed, is not made again.
"""
import argparse
import itertools
import os

import kept_run
import whipple

SCENES = {"prm/multi_plate.prm": "Ours", "prm/multi_plate_1993.prm": "With the choices of 1993"}

# Table 1 of the paper, stage by stage, as far as our copy of it can be read: end in us, CPU seconds, zones (CTH) or
# elements (DYNA2D). None: cannot be read.
TABLE_1993 = [
    (1.5, 2913, "250 x 500"),
    (3.9, 7481, "2,423"),
    (5.9, 6249, None),
    (8.3, 8168, "6,944"),
    (10.1, 5860, None),
    (12.1, 10360, "6,510"),
    (14.8, 8676, None),
    (17.8, 11850, "4,462"),
    (20.8, 6135, "250 x 750"),
]
VOIDS_1993, ALPHA_1993 = "98 or 99 %", "0.1, 1000 or 1"

HEAD = """# Four bumpers and a wall: Table 1

The main example of [Fahrenthold1993]: an aluminium sphere of 0.32 cm on four sheets of 0.0102 cm and a wall of 0.079 cm, 2.54 cm
apart. Stage by stage, beside Table 1 of the paper (in italics): first `prm/multi_plate.prm`, then `prm/multi_plate_1993.prm`, which
has the stage times and other choices of 1993.

Made by `scripts/table_1.py build{options}`.
"""

TAIL = """
## How to read it

* **Ends** of stages were chosen in 1993 by looking at plots; ours end by themselves. A debris stage ends when the leading
  edge reaches the next plate, the last stage when hole and crater have settled.
* **CPU** seconds of all ranks, hand-overs left out, on one core of today; of 1993, on its machine. They compare stages, not codes.
* **Zones**: the largest number of active cells, or the elements of a debris stage. In 1993 the mesh of CTH was uniform over its box, here
  cells are refined where there is material and empty space has none.
* **Void cutoff**: cells with more void than this are not taken over. **Alpha** in us/cm^2. Our copy of the paper gives 98 to 99 % and
  0.1, 1000 and 1.0, and does not say which stage has which; zones of three stages are lost. Where it shows
  nothing there is a "?".
* **Dropped**: mass that the hand-over into a stage leaves behind; nearly all is the plate that has been perforated. What flies
  backwards is in it, what left the domain is not. The paper gives no masses.
"""


def run(build, scene, cell, directory):
    """Summary and parameters of a run, made if it is not there."""
    path = os.path.join(directory, f"{os.path.splitext(os.path.basename(scene))[0]}_{cell}")
    summary = kept_run.kept_run(build, path, scene, [f"Mesh/Finest cell = {cell} cm", "Output/Fields interval = none"])
    return summary, whipple.Run(path).parameters


def row(stage, values, of_1993):
    end, cpu, zones = of_1993
    if stage is None:  # the run ended before it
        return f"| not reached | | | | *{end}* | | *{cpu:,}* | | *{zones or '?'}* | | | | *{ALPHA_1993}* | |"
    moving = stage["mode"] == "lagrangian"
    size = stage["elements"] if moving else stage["active_cells_max"]
    cutoff = values[f"Stages/{stage['name']}/Void cutoff"] if moving else ""
    alpha = values[f"Stages/{stage['name']}/Alpha"]
    if alpha == "as the materials say":
        alpha = values["Materials/aluminium/Alpha"]
    alpha = alpha.replace("us/cm^2", "").strip()
    return (f"| {stage['name']} | {stage['mode']} | {stage['start_us']:.2f} | {stage['end_us']:.2f} | *{end}* "
            f"| {stage['cpu_s']:.1f} | *{cpu:,}* | {size:,} | *{zones or '?'}* "
            f"| {cutoff} | {'*' + VOIDS_1993 + '*' if moving else ''} "
            f"| {alpha} | *{ALPHA_1993}* | {stage['dropped_mass_g']:.4g} |")


def table(scene, cell, summary, values):
    stages = summary["stages"]
    lines = [f"\n## {SCENES[scene]}, cells of {cell} cm\n",
             "| stage | mode | start, us | end, us | *1993* | CPU, s | *1993* | zones | *1993* | void cutoff | *1993* | alpha | "
             "*1993* | dropped, g |", "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"]
    lines += [row(stage, values, of_1993) for stage, of_1993 in itertools.zip_longest(stages, TABLE_1993)]
    cpu, dropped = sum(s["cpu_s"] for s in stages), sum(s["dropped_mass_g"] for s in stages)
    lines.append(f"| all | | | | | {cpu:.1f} | *{sum(c for _, c, _ in TABLE_1993):,}* | | | | | | | {dropped:.4g} |")
    return "\n".join(lines) + "\n" + words(summary)


def words(summary):
    """What came out, and whether the books close."""
    if summary["status"] != "completed":
        return f"\nThe run stopped: {summary['reason']}\n"
    wall = summary["results"]["wall"]
    arrivals = ", ".join(f"{s['end_us']:.2f}" for s in summary["stages"] if s["mode"] == "lagrangian")
    hole = ("cannot be seen on this mesh" if wall["hole_diameter_cm"] is None else
            f"{wall['hole_diameter_cm']:.3f} cm" if wall["perforated"] else
            f"none; crater {wall['crater_depth_cm']:.3f} cm")
    closure = max(abs(summary["ledger"][key]["closure_relative"])
                  for key in ("mass_g", "axial_momentum_g_cm_per_us", "energy_Mbar_cm3"))
    return (f"\nThe debris stages end at {arrivals} us (*3.9, 8.3, 12.1, 17.8*). Hole in the wall "
            f"at {wall['measured_at_us']:.1f} us: {hole} "
            f"(*0.16 cm* at 20.8 us; the experiment: torn, about 0.2 x 0.5 cm). Impulse on the wall "
            f"{wall['impulse_g_cm_per_us']:.4g} g cm/us of {summary['ledger']['axial_momentum_g_cm_per_us']['initial']:.4g}. "
            f"All with hand-overs: {summary['performance']['cpu_s']:.0f} CPU s. The ledger closes to {closure:.0e}.\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="build directory")
    parser.add_argument("--cells", nargs="+", default=["0.016", "0.008"], help="finest cells, cm")
    parser.add_argument("--keep", default="output/table_1", help="where runs are kept")
    arguments = parser.parse_args()
    text = HEAD.format(options="" if arguments.cells == ["0.016", "0.008"] else " --cells " + " ".join(arguments.cells))
    for scene in SCENES:
        for cell in arguments.cells:
            text += table(scene, cell, *run(arguments.build, scene, cell, arguments.keep))
    with open(os.path.join(kept_run.ROOT, "doc", "multi_plate.md"), "w", encoding="utf8") as page:
        page.write(text + TAIL)


if __name__ == "__main__":
    main()
