# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make a failing scene smaller: leave out members of lists and entries, one after the other, as long as it fails the same
way. What is not valid any more does not fail the same way and is not taken."""
import copy

LISTS = (("Stages", True), ("Bodies", True), ("Effects", False), ("Materials", True))
SIMPLER = {
    ("Mesh", "Refinement"): "uniform", ("Mesh", "Levels"): "0", ("Geometry", "Symmetry"): "planar",
    ("Geometry", "Right"): "reflecting", ("Geometry", "Bottom"): "transmitting", ("Geometry", "Top"): "transmitting",
}


def without_member(scene, section, has_subsections, name):
    smaller = copy.deepcopy(scene)
    names = [n for n in smaller[section]["List"].split(", ") if n != name]
    if not names:
        del smaller[section]
        return smaller
    smaller[section]["List"] = ", ".join(names)
    if has_subsections:
        del smaller[section][name]
    for stage in smaller.get("Stages", {}).values():  # a body that is gone enters nowhere
        if section == "Bodies" and isinstance(stage, dict) and stage.get("Introduces"):
            left = [n for n in stage["Introduces"].split(", ") if n != name]
            stage["Introduces"] = ", ".join(left) or "none"
    return smaller


def leaves(section, path=()):
    for key, value in section.items():
        if isinstance(value, dict):
            yield from leaves(value, path + (key,))
        elif key != "List":
            yield path + (key,)


def without_entry(scene, path):
    smaller = copy.deepcopy(scene)
    section = smaller
    for key in path[:-1]:
        section = section[key]
    del section[path[-1]]
    return smaller


def one_material(scene):
    """Every body of the same material."""
    for keep in scene["Materials"]["List"].split(", "):
        smaller = copy.deepcopy(scene)
        smaller["Materials"] = {"List": keep, keep: smaller["Materials"][keep]}
        for body in smaller["Bodies"].values():
            if isinstance(body, dict):
                body["Material"] = keep
        yield smaller


def candidates(scene):
    if len(scene["Materials"]["List"].split(", ")) > 1:
        yield from one_material(scene)
    for section, has_subsections in LISTS:
        for name in scene.get(section, {}).get("List", "").split(", "):
            if name:
                yield without_member(scene, section, has_subsections, name)
    for (section, key), value in SIMPLER.items():
        if scene.get(section, {}).get(key, value) != value:
            smaller = copy.deepcopy(scene)
            smaller[section][key] = value
            if (section, key) == ("Mesh", "Refinement"):
                smaller[section].pop("Buffer", None)
            yield smaller
    for path in list(leaves(scene)):
        if path[0] not in ("Output",):
            yield without_entry(scene, path)


def reduce(scene, ranks, fails):
    """@param fails (scene, ranks) -> whether it still fails the same way"""
    if ranks > 1 and fails(scene, 1):
        ranks = 1
    progress = True
    while progress:
        progress = False
        for smaller in candidates(scene):
            if fails(smaller, ranks):
                scene, progress = smaller, True
                break
    return scene, ranks
