# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units: the program works in cm, g, us (microseconds) and Mbar; here they become others, and names lose them.

1 Mbar = 1e11 Pa; 1 Mbar cm^3 = 1e5 J; 1 cm/us = 10 km/s.
"""
from .errors import Unknown

# unit -> (what is measured, how many of the program's units one of it is)
UNITS = {
    "cm": ("length", 1.0), "mm": ("length", 0.1), "m": ("length", 100.0), "um": ("length", 1e-4), "in": ("length", 2.54),
    "us": ("time", 1.0), "ns": ("time", 1e-3), "ms": ("time", 1e3), "s": ("time", 1e6),
    "g": ("mass", 1.0), "kg": ("mass", 1e3), "mg": ("mass", 1e-3),
    "cm/us": ("velocity", 1.0), "km/s": ("velocity", 0.1), "m/s": ("velocity", 1e-4),
    "g/cm^3": ("density", 1.0), "kg/m^3": ("density", 1e-3),
    "g/cm^2": ("areal density", 1.0), "kg/m^2": ("areal density", 0.1),
    "Mbar": ("pressure", 1.0), "GPa": ("pressure", 1e-2), "MPa": ("pressure", 1e-5), "Pa": ("pressure", 1e-11),
    "kbar": ("pressure", 1e-3), "bar": ("pressure", 1e-6),
    "Mbar cm^3": ("energy", 1.0), "kJ": ("energy", 1e-2), "J": ("energy", 1e-5),
    "Mbar cm^3/g": ("specific energy", 1.0), "kJ/g": ("specific energy", 1e-2), "MJ/kg": ("specific energy", 1e-2),
    "J/kg": ("specific energy", 1e-8),
    "g cm/us": ("momentum", 1.0), "N s": ("momentum", 0.1), "kg m/s": ("momentum", 0.1),
    "K": ("temperature", 1.0), "deg": ("angle", 1.0), "1": ("number", 1.0), "%": ("number", 0.01),
}

# how keys of summary.json and history.csv end -> the unit; longer ones first
SUFFIXES = {
    "g_cm_per_us": "g cm/us", "Mbar_cm3": "Mbar cm^3", "Mbar_cm": "Mbar cm", "Mbar_us": "Mbar us", "cm_per_us": "cm/us",
    "g_per_cm2": "g/cm^2", "g_per_cm3": "g/cm^3", "per_s_per_rank": "1/s", "bytes": "bytes", "deg": "deg", "cm": "cm", "us": "us",
    "g": "g", "K": "K", "s": "s",
}


def factor(unit, wanted):
    """What a number of UNIT is multiplied by to be one of WANTED. Errors: Unknown."""
    for name in (unit, wanted):
        if name not in UNITS:
            raise Unknown(f"the unit '{name}' is not known here; known: {', '.join(UNITS)}")
    (kind, size), (other, wanted_size) = UNITS[unit], UNITS[wanted]
    if kind != other:
        raise Unknown(f"'{unit}' is a {kind}, '{wanted}' a {other}")
    return size / wanted_size


def convert(values, unit, wanted):
    """Numbers (or arrays of them) of UNIT in WANTED. Errors: Unknown."""
    return values * factor(unit, wanted)


def quantity(text, wanted):
    """The number of an entry such as '0.32 cm' in the unit WANTED. Errors: Unknown."""
    number, _, unit = text.strip().partition(" ")
    try:
        value = float(number)
    except ValueError:
        raise Unknown(f"'{text}' is not a number with a unit") from None
    return convert(value, unit.strip() or "1", wanted)


def readable(key):
    """Words and unit of a key: 'hole_diameter_cm' -> ('hole diameter', 'cm')."""
    for suffix, unit in SUFFIXES.items():
        if key.endswith("_" + suffix):
            return key[:-len(suffix) - 1].replace("_", " "), unit
    return key.replace("_", " "), ""
