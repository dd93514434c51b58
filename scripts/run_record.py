# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run has written beside its fields: parameters, and what they say of bodies; summary. Standard library only."""
import json
import os


def parameters(directory):
    """Section/.../key -> value of DIR/parameters.prm; empty if there is none."""
    path = os.path.join(directory, "parameters.prm")
    values, sections = {}, []
    if not os.path.exists(path):
        return values
    with open(path, encoding="utf8") as file:
        for line in file:
            words = line.split("#")[0].strip()
            if words.startswith("subsection "):
                sections.append(words.split(None, 1)[1])
            elif words == "end":
                sections.pop()
            elif words.startswith("set "):
                key, value = words[4:].split("=", 1)
                values["/".join([*sections, key.strip()])] = value.strip()
    return values


def is_planar(values):
    return values.get("Geometry/Symmetry") == "planar"


def summary(directory):
    """DIR/summary.json; None if the run has not ended."""
    path = os.path.join(directory, "summary.json")
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf8") as file:
        return json.load(file)


UNITS = {"cm": 1.0, "mm": 0.1, "m": 100.0, "um": 1e-4, "in": 2.54,  # -> cm
         "km/s": 1.0, "m/s": 1e-3, "cm/us": 10.0,  # -> km/s
         "g/cm^3": 1.0, "kg/m^3": 1e-3,  # -> g/cm^3
         "MPa": 1.0, "GPa": 1e3, "Pa": 1e-6, "kbar": 100.0, "Mbar": 1e5}  # -> MPa


class Unknown(Exception):
    """What was asked for is not in this run, or cannot be told from it."""


def quantity(text):
    """A number with one of these units, in cm, km/s, g/cm^3 or MPa."""
    number, _, unit = text.strip().partition(" ")
    try:
        return float(number) * UNITS[unit.strip()]
    except (ValueError, KeyError):
        raise Unknown(f"'{text}' is not understood here; units that are: {', '.join(UNITS)}") from None


def bodies(values):
    """Name -> entries of each body."""
    names = [name.strip() for name in values.get("Bodies/List", "").split(",") if name.strip()]
    return {name: {key: values.get(f"Bodies/{name}/{key}", "") for key in
                   ("Shape", "Diameter", "Velocity", "Front face", "Thickness", "Density", "Material")} for name in names}


def plates(values):
    """[(name, front, thickness)] of the plates, cm, along the line of flight."""
    found = [(name, quantity(body["Front face"]), quantity(body["Thickness"]))
             for name, body in bodies(values).items() if body["Shape"] == "plate"]
    return sorted(found, key=lambda plate: plate[1])
