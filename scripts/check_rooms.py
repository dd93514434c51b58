#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Include paths point one way: each room (folder of include/whipple and source) includes only rooms that stand before it.

    check_rooms.py [ROOT]

Exit status 1 and a line for each include that points back, and for each source file that is not in source/sources.cmake.
"""
import os
import re
import sys

# From what knows nothing to what knows most. A room may include those before it and itself.
ORDER = [
    "material", "mesh", "state", "output", "exact", "hydro", "remap", "projection", "effect", "refinement", "scene", "problem",
    "ledger", "initial", "diagnostics", "run", "study", "command",
]

# A scene is what the file says: plain data. From other rooms than these it may include only headers of plain data, which
# include nothing but each other and the standard library; models, fields and kernels are for the problem.
SCENE_KNOWS = {"scene", "mesh"}
PLAIN = {
    "effect/effect_parameters.h", "effect/effect_verdict.h", "hydro/hydro_parameters.h", "material/material_request.h", "projection/projection_parameters.h", "state/kinetic_loss.h",
}
# Source files, not headers: entries of the sections "Mesh" and "Stages" stand beside what reads them.
SCENE_SOURCES_KNOW = {"refinement/refinement_criterion.h", "projection/representation.h"}


def scene_may(inside, other, header):
    """Whether a file of the room scene may include <whipple/other/header>."""
    target = f"{other}/{header}"
    return other in SCENE_KNOWS or target in PLAIN or (inside.endswith(".cc") and target in SCENE_SOURCES_KNOW)


def files(root):
    for base in ("include/whipple", "source"):
        for folder, _, names in os.walk(os.path.join(root, base)):
            for name in sorted(names):
                if name.endswith((".h", ".cc")):
                    path = os.path.join(folder, name)
                    inside = os.path.relpath(path, os.path.join(root, base))
                    yield path, inside.split(os.sep)[0] if os.sep in inside else ""


def main():
    root = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    place = {room: number for number, room in enumerate(ORDER)}
    faults, count = [], 0
    with open(os.path.join(root, "source/sources.cmake"), encoding="utf8") as file:
        listed = set(re.findall(r"source/\S+\.cc", file.read()))
    for path, room in files(root):
        shown = os.path.relpath(path, root)
        if room and room not in place:
            faults.append(f"{shown}: the room {room} is not in the order of scripts/check_rooms.py")
            continue
        if path.endswith(".cc") and room and shown not in listed:
            faults.append(f"{shown}: is not in source/sources.cmake, so it is not built")
        with open(path, encoding="utf8") as file:
            for number, line in enumerate(file, 1):
                found = re.match(r"#include <whipple/(\w+)/([\w.]+)>", line)
                if not found:
                    continue
                count += 1
                other, header = found.groups()
                if room == "scene" and not scene_may(path, other, header):
                    faults.append(f"{shown}:{number}: scene includes {other}/{header}, which is no plain data")
                if f"{room}/{os.path.basename(path)}" in PLAIN and f"{other}/{header}" not in PLAIN:
                    faults.append(f"{shown}:{number}: a header of plain data includes {other}/{header}")
                if room and place.get(other, len(ORDER)) > place[room]:
                    faults.append(f"{shown}:{number}: {room} includes {other}, which stands after it")
    for fault in faults:
        print(fault)
    if faults:
        sys.exit(1)
    print(f"{count} includes, {len(ORDER)} rooms: all point one way")


if __name__ == "__main__":
    main()
