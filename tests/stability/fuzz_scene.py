# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random valid scenes. A scene is a nested dict in the order of the file: section -> entries. The same seed, number and
work give the same scene."""
import math
import random

GENERATOR = 2         # another number when the same seed gives other scenes than before: records are not mixed
WORK = 60_000         # cell steps of a scene, as predicted: some 2 s of a core under sanitizers, 0.1 s without, and the start
STEPS = (60, 300)     # least and most of a scene, as predicted; a scene that is too large for the least is drawn again
LEAST_WORK = 20_000   # smaller scenes are hardly ever drawn
COURANT, SOUND = 0.4, 0.7  # of the prediction; cm/us
BUFFER = 3            # cells around a body that a fixed mesh has, too
WITHOUT_LAW = 0.1     # part of the scenes in which a material may lack the void law that a moving mesh needs

# library name -> what the library has for it
METALS = {
    "aluminium 2024-T4": ("johnson-cook", "steinberg-guinan", "damage", "fragments"),
    "aluminium 6061-T6": ("johnson-cook", "steinberg-guinan", "damage", "fragments"),
    "aluminium 7075-T6": ("johnson-cook", "steinberg-guinan", "fragments"),
    "copper OFHC": ("johnson-cook", "steinberg-guinan", "damage"),
    "stainless steel 304": ("steinberg-guinan",),
    "tantalum": ("steinberg-guinan",),
    "zinc": ("steinberg-guinan",),
    "lead": ("steinberg-guinan",),
    "beryllium S-200": ("steinberg-guinan",),
}
CONDUCTS = ("aluminium 2024-T4", "aluminium 6061-T6", "copper OFHC", "tantalum", "zinc", "stainless steel 304")
CURVED = ("lead", "nylon 6/6", "polyethylene", "lexan", "lucite")
TILLOTSON = ("aluminium", "copper", "iron", "nylon", "water", "granite")


def units(value, unit):
    """All digits for lengths: bodies that touch must not overlap in the last one."""
    return f"{value!r} cm" if unit == "cm" else f"{value:.6g} {unit}"


def pair(first, second):
    return f"{units(first, 'cm')}, {units(second, 'cm')}"


def logarithmic(r, low, high):
    return low * (high / low) ** r.random()


def text(scene, indent=""):
    """The scene as a .prm file."""
    lines = []
    for key, value in scene.items():
        if isinstance(value, dict):
            lines += [f"{indent}subsection {key}", text(value, indent + "  ").rstrip("\n"), f"{indent}end"]
        else:
            lines.append(f"{indent}set {key} = {value}")
    return "\n".join(line for line in lines if line.strip()) + "\n"


def strength(r, library, material, constants):
    """A law of strength and what it needs."""
    kinds = ["none", "perfectly plastic", "linear hardening"]
    kinds += [kind for kind in ("johnson-cook", "steinberg-guinan") if kind in constants]
    kind = r.choice(kinds)
    material["Strength"] = kind
    if kind in ("perfectly plastic", "linear hardening") and (library not in METALS or r.random() < 0.3):
        material["Shear modulus"] = units(r.uniform(5, 80), "GPa")
        material["Yield stress"] = units(logarithmic(r, 10, 2000), "MPa")
    if kind in ("johnson-cook", "steinberg-guinan"):
        material["Thermal model"] = "constant specific heat"
    if kind == "linear hardening":
        material["Hardening modulus"] = units(logarithmic(r, 10, 1000), "MPa")


def void_law(r, material, needed):
    kind = r.choice(["rate" if needed else "none", "rate", "rate", "equilibrium", "p-alpha"])
    material["Void law"] = kind
    if kind == "rate":
        material["Alpha"] = r.choice([units(logarithmic(r, 1e-2, 1e9), "us/cm^2"), "0 us/cm^2", "infinite"])
    if kind in ("rate", "equilibrium") and r.random() < 0.8:
        material["Spall strength"] = r.choice([units(logarithmic(r, 0.05, 3), "GPa"), "0 GPa"])
    if kind == "p-alpha":
        elastic = logarithmic(r, 1, 500)
        material["Initial porosity"] = f"{r.uniform(0.05, 0.7):.3f}"
        material["Elastic crush pressure"] = units(elastic, "MPa")
        material["Full compaction pressure"] = units(elastic * r.uniform(1.5, 30), "MPa")
        if r.random() < 0.5:
            material["Spall strength"] = units(logarithmic(r, 0.01, 1), "GPa")
    return kind


def solid(r, voids):
    """A condensed material with its laws."""
    kind = r.choices(["mie-grueneisen", "cubic mie-grueneisen", "tillotson", "solid-liquid-vapour", "linear polynomial",
                      "stiffened gas"], [6, 2, 3, 1, 1, 1])[0]
    material = {}
    if kind in ("mie-grueneisen", "linear polynomial"):
        library = r.choice(list(METALS))
    else:
        library = {"cubic mie-grueneisen": r.choice(CURVED), "tillotson": r.choice(TILLOTSON),
                   "solid-liquid-vapour": "aluminium", "stiffened gas": None}[kind]
    if library:
        material["Library"] = library
    material["Equation of state"] = kind
    if kind == "stiffened gas":
        material.update({"Density": units(r.uniform(0.5, 3), "g/cm^3"), "Sound speed": units(r.uniform(0.5, 3), "km/s"),
                         "Adiabatic exponent": f"{r.uniform(1.2, 5):.3f}"})
    constants = METALS.get(library, ()) if kind in ("mie-grueneisen", "linear polynomial") else ()
    if kind != "stiffened gas":
        strength(r, library if constants else None, material, constants)
    void = void_law(r, material, voids)
    if void != "none" and material.get("Strength", "none") != "none" and r.random() < 0.3:
        material["Failure"] = "johnson-cook damage" if "damage" in constants and r.random() < 0.5 else "spall"
        if void == "p-alpha":
            material["Failure void fraction"] = f"{min(0.95, float(material['Initial porosity']) + 0.1):.3f}"
    if void != "none" and "fragments" in constants and r.random() < 0.3:
        material["Fragments"] = "grady-kipp"
    if kind == "solid-liquid-vapour" and r.random() < 0.5:
        material["Thermal model"] = "equation of state"
    elif constants and r.random() < 0.4:
        material["Thermal model"] = "constant specific heat"
    if material.get("Thermal model") == "constant specific heat" and library in CONDUCTS and r.random() < 0.3:
        material["Conduction"] = "constant conductivity"
    if material.get("Failure") == "johnson-cook damage":
        material.setdefault("Thermal model", "constant specific heat")  # its ductility depends on temperature
    return material


def effects(r, materials, voids):
    """What the materials can do, most of it on."""
    wanted = []
    has = lambda key: any(m.get(key, "none") != "none" for m in materials.values())
    if has("Strength") and r.random() < 0.9:
        wanted.append("strength")
    porous = any(m.get("Void law") == "p-alpha" for m in materials.values())  # pores need the effect
    if has("Void law") and (r.random() < 0.9 or porous or voids):
        wanted.append("voids")
        if has("Failure") and r.random() < 0.8:
            wanted.append("failure")
            if "strength" not in wanted and any(m.get("Failure") == "johnson-cook damage" for m in materials.values()):
                wanted.append("strength")  # it goes by plastic strain
        if has("Fragments") and r.random() < 0.8:
            wanted.append("fragment size")
    if has("Thermal model") and r.random() < 0.8:
        wanted.append("melting")
    if has("Conduction") and r.random() < 0.8:
        wanted.append("heat conduction")
    if r.random() < 0.5:
        wanted.append("body tags")
    return wanted


def aligned(r, value, cell):
    """On a line of the mesh, near one, or anywhere."""
    kind = r.random()
    line = round(value / cell) * cell
    return line if kind < 0.4 else line + cell * 10 ** r.uniform(-12, -1) if kind < 0.5 else value


def lengths(text_of_pair):
    """cm"""
    return [float(part.split()[0]) for part in text_of_pair.split(",")]


def cells_of(all_bodies, planar, cell, width, height):
    """About as many cells are active: those of the bodies and some around them, no more than the domain has."""
    area = edge = 0.
    for body in all_bodies.values():
        if body["Shape"] == "sphere":
            diameter = lengths(body["Diameter"])[0]
            part = 1. if planar and lengths(body["Center"])[0] > 0 else 0.5
            area, edge = area + part * math.pi / 4 * diameter**2, edge + part * math.pi * diameter
            continue
        if body["Shape"] == "box":
            (x0, y0), (x1, y1) = lengths(body["Lower corner"]), lengths(body["Upper corner"])
            sides = (x1 - x0, y1 - y0)
        else:
            sides = (lengths(body.get("Half width", units(width, "cm")))[0], lengths(body["Thickness"])[0])
        area, edge = area + sides[0] * sides[1], edge + 2 * sum(sides)
    return min(area / cell**2 + BUFFER * edge / cell, width * height / cell**2)


def bodies(r, planar, names, cell, width, speed, on_lines):
    """Striker, plates behind one another, perhaps a second striker and gas between the plates; the top of all."""
    result = {}
    diameter = cell * r.uniform(3, 12)  # at most the width of the narrowest domain
    sideways = speed * r.uniform(-1, 1) if planar and r.random() < 0.4 else 0.
    motion = f"{sideways:.6g} km/s, {speed:.6g} km/s"
    gap = r.choice([0., cell * r.uniform(0.01, 3)])
    top = -gap
    beside = planar and diameter < 0.8 * width and r.random() < 0.5
    middle = diameter / 2 + (0.05 + 0.9 * r.random()) * (width - diameter) if beside else 0.
    if r.random() < 0.6:
        result["striker"] = {"Shape": "sphere", "Center": pair(middle, top - diameter / 2), "Diameter": units(diameter, "cm")}
        low = top - diameter
    else:
        length = max(0.3 * cell, diameter * r.uniform(0.2, 2))
        x0 = 0. if middle == 0. else max(0., aligned(r, middle - diameter / 2, cell))
        x1 = min(width, aligned(r, middle + diameter / 2, cell))
        low = top - length
        result["striker"] = {"Shape": "box", "Lower corner": pair(x0, low), "Upper corner": pair(x1, top)}
    result["striker"].update({"Velocity": motion, "Material": r.choice(names["solid"])})
    if r.random() < 0.3:
        side = cell * r.uniform(1, 4)
        x0 = 0. if not planar else width * r.uniform(0.1, 0.6)
        y1 = low - cell * r.uniform(0.1, 3)
        result["second"] = {"Shape": "box", "Lower corner": pair(x0, y1 - side), "Upper corner": pair(x0 + side, y1),
                            "Velocity": f"{r.uniform(-0.2, 0.2) * speed if planar else 0:.6g} km/s, {speed * r.uniform(0.3, 3):.6g} km/s",
                            "Material": r.choice(names["solid"])}
        low = y1 - side
    front = 0.
    for i in range(r.choice([1, 1, 2, 3])):
        thick = cell * r.choice([r.uniform(0.1, 2), r.uniform(1, 6), float(r.randint(1, 6))])
        if r.random() < 0.5:
            thick = max(aligned(r, front + thick, cell) - front, 0.05 * cell)
        rear = front + thick  # as the program adds them
        result[f"plate{i}"] = {"Shape": "plate", "Front face": units(front, "cm"), "Thickness": units(thick, "cm"),
                               "Material": r.choice(names["solid"])}
        if r.random() < 0.2:
            result[f"plate{i}"]["Half width"] = units(width * r.uniform(0.3, 0.9), "cm")
        front = rear + r.choice([0., cell * r.uniform(0.01, 1), cell * r.uniform(2, 10)])
    if names["gas"]:
        depth = cell * r.uniform(4, 12)
        if on_lines:  # no cell of the gas has open void, which it could not take up
            rear, depth = math.ceil(rear / cell) * cell, round(depth / cell) * cell
        result["filling"] = {"Shape": "plate", "Front face": units(rear, "cm"), "Thickness": units(depth, "cm"),
                             "Material": names["gas"][0], "Pressure": units(logarithmic(r, 0.1, 300), "MPa")}
        front = rear + depth
    return result, low, front


def modes_of(r):
    """One to four modes of stages, and whether a moving mesh follows a fixed one."""
    handed_over = r.random() < 0.6
    chains = [["eulerian", "lagrangian"], ["eulerian", "lagrangian", "eulerian"], ["lagrangian", "eulerian", "lagrangian", "eulerian"]]
    return r.choice(chains if handed_over else [["eulerian"], ["lagrangian"], ["lagrangian", "eulerian"]]), handed_over


def stages(r, all_bodies, modes, step, steps):
    """Stages of these modes; Lagrangian ones of all cohesions anywhere."""
    result = {}
    plates = [name for name in all_bodies if name.startswith("plate")]
    late = plates[-1] if len(plates) > 1 and "filling" not in all_bodies and r.random() < 0.5 else None
    if modes[-1] != "eulerian" or len(modes) == 1:
        late = None
    for i, mode in enumerate(modes):
        stage = result[f"s{i}"] = {"Mode": mode, "End": f"for {step * steps / len(modes) * r.uniform(0.5, 1.5):.6g} us"}
        if late:
            others = ", ".join(name for name in all_bodies if name != late)
            stage["Introduces"] = others if i == 0 else late if i == len(modes) - 1 else "none"
        if r.random() < 0.2:
            stage["Lost kinetic energy"] = "drop"
        if mode == "lagrangian":
            stage["Cohesion"] = r.choice(["bonded", "graded", "fragments"])
            if i > 0:
                stage["Minimum axial velocity"] = r.choice(["0 %", "10 %"])
                stage["Void cutoff"] = r.choice(["99 %", "90 %"])
                if r.random() < 0.3:
                    stage["Debris behind"] = plates[0]
        elif i > 0:
            stage["Representation"] = r.choice(["distended", "packages"])
    return result


def make(seed, number, work=WORK):
    """Scene `number` of a seed: (scene, ranks)."""
    r = random.Random(f"whipple {seed} {number}")
    planar = r.random() < 0.5
    speed = logarithmic(r, 0.1, 20)
    cell = 0.02 * r.choice([1., 1., 1., logarithmic(r, 0.01, 100)])
    modes, handed_over = modes_of(r)
    # what lies beside open void in an element needs a void law; a scene that goes over to elements is refused without
    voids = handed_over or "lagrangian" in modes and r.random() >= WITHOUT_LAW
    materials = {f"m{i}": solid(r, voids) for i in range(r.choice([1, 1, 2, 3]))}
    names = {"solid": list(materials), "gas": []}
    if not handed_over and r.random() < 0.3:
        materials["gas"] = {"Equation of state": "ideal gas", "Density": units(logarithmic(r, 1e-3, 0.1), "g/cm^3"),
                            "Adiabatic exponent": f"{r.uniform(1.1, 1.7):.3f}"}
        names["gas"] = ["gas"]
    root = 4 * cell
    cells = math.inf
    while cells * STEPS[0] > work:
        width = cell * r.choice([12, 16, 24])
        all_bodies, low, high = bodies(r, planar, names, cell, width, speed, voids)
        low, high = (low // root - 1) * root, (high // root + 3) * root
        cells = cells_of(all_bodies, planar, cell, width, high - low)
    sides = lambda: r.choice(["transmitting", "transmitting", "reflecting"])
    scene = {"Title": f"fuzz {seed} {number}"}
    scene["Geometry"] = {"Symmetry": "planar" if planar else "axisymmetric",
                         "Lower corner": pair(0, low), "Upper corner": pair(width, high),
                         "Left": "reflecting", "Right": sides(), "Bottom": sides(), "Top": sides()}
    levels = r.choice([0, 0, 1, 2])
    scene["Mesh"] = {"Finest cell": units(cell, "cm"), "Levels": str(levels),
                     "Refinement": r.choice(["adaptive", "uniform"]) if levels else "uniform"}
    if scene["Mesh"]["Refinement"] == "adaptive":
        scene["Mesh"]["Buffer"] = str(r.choice([2, 4, 8]))
    listed = list(materials)
    r.shuffle(listed)
    scene["Materials"] = {"List": ", ".join(listed), **materials}
    wanted = effects(r, materials, voids)
    if wanted:
        scene["Effects"] = {"List": ", ".join(wanted)}
    scene["Bodies"] = {"List": ", ".join(all_bodies), **all_bodies}
    step = COURANT * cell / (SOUND + 0.1 * speed)
    chain = stages(r, all_bodies, modes, step, min(STEPS[1], work / cells))
    scene["Stages"] = {"List": ", ".join(chain), **chain}
    if r.random() < 0.3:
        scene["Numerics"] = r.choice([{"Viscosity": "tensor"}, {"Remap order": "1"}, {"Courant number": f"{r.uniform(0.1, 0.9):.2f}"},
                                      {"Hourglass coefficient": f"{r.uniform(0, 0.3):.2f}"}])
    scene["Output"] = {"Fields interval": "none"}
    return scene, r.choice([1, 1, 1, 1, 1, 1, 2, 2, 3])


def members(scene, section):
    """Entries of the members of a list."""
    return [entries for entries in scene.get(section, {}).values() if isinstance(entries, dict)]


def kinds(scene, ranks):
    """What a scene tries: (group, kind), each once."""
    found = {("geometry", scene["Geometry"]["Symmetry"]), ("ranks", str(ranks)),
             ("levels", f"{scene['Mesh'].get('Levels', '0')} {scene['Mesh'].get('Refinement', '')}".strip()),
             ("stages", " - ".join(stage["Mode"] for stage in members(scene, "Stages")))}
    fastest = max(abs(v) for body in members(scene, "Bodies") for v in lengths(body.get("Velocity", "0")))
    found.add(("fastest body", next((f"below {bound} km/s" for bound in (0.3, 1, 3, 10) if fastest < bound), "from 10 km/s")))
    for section, key, group in (("Materials", "Equation of state", "equation of state"), ("Materials", "Strength", "strength"),
                                ("Materials", "Void law", "void law"), ("Materials", "Failure", "failure"),
                                ("Stages", "Cohesion", "cohesion"), ("Stages", "Representation", "representation"), ("Bodies", "Shape", "shape")):
        found.update((group, entries[key]) for entries in members(scene, section) if entries.get(key, "none") != "none")
    found.update(("effect", effect) for effect in scene.get("Effects", {}).get("List", "").split(", ") if effect)
    found.update(("numerics", key.lower()) for key in scene.get("Numerics", {}))
    return found
