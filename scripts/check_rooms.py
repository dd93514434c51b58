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
    "material", "mesh", "state", "output", "exact", "hydro", "remap", "projection", "effect", "scene", "refinement", "problem",
    "ledger", "initial", "diagnostics", "run", "study", "command",
]


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
                found = re.match(r"#include <whipple/(\w+)/", line)
                if not found:
                    continue
                count += 1
                other = found.group(1)
                if room and place.get(other, len(ORDER)) > place[room]:
                    faults.append(f"{shown}:{number}: {room} includes {other}, which stands after it")
    for fault in faults:
        print(fault)
    if faults:
        sys.exit(1)
    print(f"{count} includes, {len(ORDER)} rooms: all point one way")


if __name__ == "__main__":
    main()
