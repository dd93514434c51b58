#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run the cases of the paper with its choices, and with each of them taken back alone, and write doc/choices_1993.md.

    scripts/choices_page.py BUILD_DIRECTORY [--cells 0.016 0.008] [--keep DIRECTORY]

Two runs at a time. Runs that are in DIRECTORY already, and completed, are not made again.
"""
import argparse
import concurrent.futures
import os

import kept_run

EULERIAN = ["perforation 1", "perforation 2", "perforation 3", "perforation 4", "impact"]
MOVING = ["debris 1", "debris 2", "debris 3", "debris 4"]
METAL = "Materials/aluminium"


def in_stages(names, entry):
    return [f"Stages/{name}/{entry}" for name in names]


# What 1993 chose, and what stands for it when it is taken back.
CHOICES = {
    "1993": ("all of its choices", []),
    "equation of state": ("isothermal polynomial -> mie-grueneisen with energy",
                          [f"{METAL}/Equation of state = mie-grueneisen", f"{METAL}/Isothermal = false"]),
    "strength": ("linear hardening -> perfectly plastic", [f"{METAL}/Hardening modulus = 0 GPa"]),
    "alpha": ("0.1, 1000, 1 us/cm^2 -> 1e5 in all stages",
              [f"{METAL}/Alpha = 1e5 us/cm^2", *in_stages(EULERIAN + MOVING, "Alpha = as the materials say")]),
    "representation: fragments": ("packages -> fragments of Grady and Kipp's size",
                                  ["Effects/List = strength, voids, body tags, fragment size", f"{METAL}/Fragments = grady-kipp",
                                   *in_stages(EULERIAN[1:], "Representation = fragments")]),
    "representation: dust": ("packages -> distended", in_stages(EULERIAN[1:], "Representation = distended")),
    "lost kinetic energy": ("dropped -> heat", in_stages(EULERIAN + MOVING, "Lost kinetic energy = heat")),
    "void cutoff": ("99 and 98 % -> 99.9 %", in_stages(MOVING, "Void cutoff = 99.9 %")),
    "plates": ("left at the end of their stage -> debris that comes late is not dropped (least velocity 0)",
               in_stages(MOVING, "Minimum axial velocity = 0 %")),
    "6.3 km/s": ("6.58 km/s -> 6.3", ["Bodies/sphere/Velocity = 0 km/s, 6.3 km/s"]),
    "6.8 km/s": ("6.58 km/s -> 6.8", ["Bodies/sphere/Velocity = 0 km/s, 6.8 km/s"]),
}

# The single bumper: the wall of 1993 had 96.6 MPa and was perforated; catalogues give 345 MPa, and the experiment's held.
SINGLE = {(representation, strength): [f"Stages/wall/Representation = {representation}", f"{METAL}/Yield stress = {strength}",
                                       "Stages/wall/End = for 8 us", *alpha]
          for representation, alpha in (("packages", [f"{METAL}/Alpha = 1e5 us/cm^2", "Stages/perforation/Alpha = 0.1 us/cm^2",
                                                      "Stages/debris/Alpha = 1000 us/cm^2", "Stages/wall/Alpha = 1 us/cm^2"]),
                                        ("distended", []))
          for strength in ("96.6 MPa", "345 MPa")}

HEAD = """# What the choices of 1993 change

The paper's two cases with its choices, and each of them taken back alone. A run is one scene of the repository and the
settings named. What differs between 1993 and the experiment, and between 1993 and us, can so be given to its causes, as far as
causes add up.

Made by `scripts/choices_page.py build{options}`.
"""


def run(build, folder, name, scene, settings, cell):
    directory = os.path.join(folder, f"{name} {cell}".replace(" ", "_").replace("/", "_per_").replace(":", ""))
    return kept_run.kept_run(build, directory, scene, [f"Mesh/Finest cell = {cell} cm", "Output/Fields interval = none", *settings])


def wall(summary):
    """Hole, what is left of the wall, and when it was looked at."""
    if summary["status"] != "completed":
        return "stopped", "", ""
    result = summary["results"]["wall"]
    if result["perforated"] is None:
        return "cannot be seen", "", ""
    hole = f"{result['hole_diameter_cm']:.3f}" if result["perforated"] else "none"
    return hole, f"{result['least_thickness_cm']:.3f}", f"{result['crater_depth_cm']:.3f}"


def four_bumpers(arguments, pool):
    text = """
## Four bumpers

`prm/multi_plate_1993.prm`: the stage times of Table 1, wall looked at 20.8 us after first contact. 1993: hole of 0.16 cm; the
experiment: torn, about 0.2 x 0.5 cm. The wall is 0.079 cm thick; "crater" is how deep its front has gone, its bulge included.
"""
    for cell in arguments.cells:
        jobs = {name: pool.submit(run, arguments.build, arguments.keep, name, "prm/multi_plate_1993.prm", settings, cell)
                for name, (_, settings) in CHOICES.items()}
        text += (f"\nCells of {cell} cm:\n\n| taken back | to | hole, cm | change, cm | least thickness, cm | crater, cm | steps |\n"
                 "|---|---|---|---|---|---|---|\n")
        hole_of = lambda summary: (summary["results"].get("wall", {}).get("hole_diameter_cm") or 0.
                                   if summary["status"] == "completed" else None)
        reference = hole_of(jobs["1993"].result())
        for name, (what, _) in CHOICES.items():
            summary = jobs[name].result()
            hole, left, crater = wall(summary)
            own = hole_of(summary)
            change = "" if name == "1993" or own is None else f"{own - reference:+.3f}"
            steps = sum(stage["steps"] for stage in summary["stages"])
            text += f"| {name} | {what} | {hole} | {change} | {left} | {crater} | {steps:,} |\n"
    return text


def single_bumper(arguments, pool):
    text = """
## Single bumper

`prm/whipple_shield.prm`, wall of 0.127 cm looked at 8 us after the first debris has reached it. 1993 had packages, the alphas 0.1, 1000
and 1 us/cm^2 and a yield stress of 96.6 MPa, and perforated the wall; the experiment, whose metal has 345 MPa, did not.
"""
    for cell in arguments.cells:
        jobs = {key: pool.submit(run, arguments.build, arguments.keep, f"single {key[0]} {key[1]}", "prm/whipple_shield.prm",
                                 settings, cell) for key, settings in SINGLE.items()}
        text += (f"\nCells of {cell} cm:\n\n| debris | yield stress | hole, cm | least thickness, cm | crater, cm | arrival, us |\n"
                 "|---|---|---|---|---|---|\n")
        for (representation, strength), job in jobs.items():
            hole, left, crater = wall(job.result())
            debris = "packages, alphas of 1993" if representation == "packages" else "distended, alpha 1e5"
            text += f"| {debris} | {strength} | {hole} | {left} | {crater} | {job.result()['stages'][1]['end_us']:.2f} |\n"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="build directory")
    parser.add_argument("--cells", nargs="+", default=["0.016", "0.008"], help="finest cells, cm")
    parser.add_argument("--keep", default="output/choices", help="where runs are kept")
    arguments = parser.parse_args()
    options = "" if arguments.cells == ["0.016", "0.008"] else " --cells " + " ".join(arguments.cells)
    text = HEAD.format(options=options)
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        text += single_bumper(arguments, pool) + four_bumpers(arguments, pool)
    page = os.path.join(kept_run.ROOT, "doc", "choices_1993.md")
    tail = ""
    if os.path.exists(page):  # what has been said about it stays
        with open(page, encoding="utf8") as file:
            _, mark, rest = file.read().partition("\n## What they say\n")
            tail = mark + rest
    with open(page, "w", encoding="utf8") as file:
        file.write(text + tail)


if __name__ == "__main__":
    main()
