# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the parameters of a run say of its scene: symmetry, bodies, plates, when the projectile touches."""
from dataclasses import dataclass

from .errors import Unknown
from .units import quantity

BODY_ENTRIES = ("Shape", "Diameter", "Velocity", "Front face", "Thickness", "Density", "Material", "Center", "Rotation")


@dataclass(frozen=True)
class Plate:
    """front, thickness: cm, along axis 1 (the line of flight)."""

    name: str
    front: float
    thickness: float

    @property
    def rear(self):
        return self.front + self.thickness


def names(text):
    """Words of a list 'a, b, c'."""
    return [word.strip() for word in text.split(",") if word.strip()]


def is_planar(parameters):
    """Planar scenes are not mirrored about an axis."""
    return parameters.get("Geometry/Symmetry") == "planar"


def bodies(parameters):
    """Name -> entries of each body, in the order of the scene."""
    return {name: {key: parameters.get(f"Bodies/{name}/{key}", "") for key in BODY_ENTRIES}
            for name in names(parameters.get("Bodies/List", ""))}


def materials(parameters):
    """Names of the materials."""
    return names(parameters.get("Materials/List", ""))


def plates(parameters):
    """The plates that lie across the line of flight, in its order; turned ones do not. Errors: Unknown."""
    found = [Plate(name, quantity(body["Front face"], "cm"), quantity(body["Thickness"], "cm"))
             for name, body in bodies(parameters).items()
             if body["Shape"] == "plate" and quantity(body["Rotation"] or "0 deg", "deg") == 0.0]
    return sorted(found, key=lambda plate: plate.front)


def axial(text, unit):
    """The second number of 'r, z' in a unit."""
    parts = names(text)
    return quantity(parts[1], unit) if len(parts) == 2 else 0.0


def contact_time(parameters):
    """When the first sphere touches the first plate, us after the start: distance over velocity. 0 where that cannot be told (other
    shapes, no plate), so that the time since contact is the time of the run."""
    try:
        front = plates(parameters)[0].front
        for body in bodies(parameters).values():
            speed = axial(body["Velocity"], "cm/us") if body["Velocity"] else 0.0
            if body["Shape"] == "sphere" and speed > 0.0:
                centre = axial(body["Center"], "cm")
                return max(front - centre - 0.5 * quantity(body["Diameter"], "cm"), 0.0) / speed
    except (Unknown, IndexError):
        pass
    return 0.0
