# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pictures can show, by name: which field, in which unit and colours, and one scale for a whole run."""
from dataclasses import dataclass

import matplotlib
import numpy as np
from matplotlib.colors import LinearSegmentedColormap, LogNorm, Normalize, SymLogNorm

BACKGROUND = (0.885, 0.875, 0.845)  # neither white, which is zero, nor any of the colours
BODY_COLOURS = ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#b8860b", "#56b4e9", "#7a3b8f", "#5a6472"]
SOLID_ENOUGH = 1e-3  # solid fraction of elements that a scale is made for


@dataclass(frozen=True)
class Quantity:
    """kind: log (powers of ten below the largest), zero (from 0), signed (white is 0), signed log, share (0 to 1), range."""

    name: str
    field: str
    unit: str
    label: str
    colours: str
    kind: str
    decades: int = 4


def truncated(name, low, high=1.0):
    """A map of colours without its lightest part, which the background would swallow."""
    return LinearSegmentedColormap.from_list(name, matplotlib.colormaps[name](np.linspace(low, high, 256)))


COLOURS = {"dense": truncated("magma_r", 0.12, 0.97), "fast": truncated("viridis_r", 0.0), "signed": matplotlib.colormaps["RdBu_r"],
           "hot": truncated("YlOrRd", 0.1), "share": truncated("YlGnBu", 0.12), "level": truncated("YlGnBu", 0.1, 0.65)}

KNOWN = {quantity.name: quantity for quantity in (
    Quantity("density", "density", "g/cm^3", "density, g/cm³", "dense", "log"),
    Quantity("solid", "solid fraction", "", "solid fraction", "dense", "log"),
    Quantity("void fraction", "void fraction", "", "void fraction", "share", "share"),
    Quantity("speed", "speed", "km/s", "speed, km/s", "fast", "zero"),
    Quantity("velocity", "axial velocity", "km/s", "axial velocity, km/s", "signed", "signed"),
    Quantity("pressure", "pressure", "GPa", "pressure, GPa", "signed", "signed log", 3),
    Quantity("temperature", "temperature", "K", "temperature, K", "hot", "range"),
    Quantity("plastic strain", "plastic strain", "", "plastic strain", "hot", "zero"),
    Quantity("melt", "melt fraction", "", "melt fraction", "hot", "share"),
    Quantity("damage", "damage", "", "damage", "hot", "share"),
    Quantity("energy", "energy", "kJ/g", "specific internal energy, kJ/g", "hot", "zero"),
    Quantity("bodies", "", "", "bodies", "", "bodies"),
    Quantity("mesh", "level", "", "refinement level", "level", "range"),
)}


def quantity_of(name, snapshot):
    """The quantity of a name: one of KNOWN, or any field of the run. Errors: whipple.Unknown."""
    if name in KNOWN:
        known = KNOWN[name]
        if known.field:
            snapshot.field(known.field)
        return known
    found = snapshot.field(name)
    unit = f", {found.unit}" if found.unit not in ("", "1") else ""
    return Quantity(name, name, "", name + unit, "signed", "any")


def values_of(quantity, snapshot):
    """Of each element."""
    return np.asarray(snapshot.field(quantity.field, quantity.unit or None).values, dtype=float)


def extremes(quantity, snapshot):
    """Least and largest value at one time, but for a thousandth of the elements at either end, of what is not a wisp."""
    if quantity.kind in ("bodies", "share"):
        return 0.0, 1.0
    values = values_of(quantity, snapshot)
    seen = np.isfinite(values)
    solid = seen & (snapshot.array("solid_fraction") > SOLID_ENOUGH)
    values = values[solid if solid.any() else seen]
    return tuple(np.quantile(values, [0.001, 0.999])) if len(values) else (0.0, 0.0)


def round_up(value):
    """The next of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 times a power of ten."""
    if not value > 0.0:
        return 1.0
    power = 10.0**np.floor(np.log10(value))
    return power * next(step for step in (1, 1.5, 2, 3, 4, 5, 6, 8, 10, 10) if step * power >= 0.999 * value)


@dataclass(frozen=True)
class Scale:
    """The same for all pictures of a run."""

    quantity: Quantity
    low: float
    high: float

    @property
    def is_signed(self):
        return self.quantity.kind.startswith("signed") or self.quantity.kind == "any" and self.low < 0.0

    def norm(self):
        kind, low, high = self.quantity.kind, self.low, self.high
        widest = round_up(max(abs(low), abs(high)))
        if kind == "log":
            least = 10.0**np.floor(np.log10(low)) if 0.0 < low < high else 0.0
            return LogNorm(max(round_up(high) * 10.0**-self.quantity.decades, least), round_up(high), clip=True)
        if kind == "signed log":
            return SymLogNorm(widest * 10.0**-self.quantity.decades, vmin=-widest, vmax=widest, base=10, clip=True)
        if self.is_signed:
            return Normalize(-widest, widest, clip=True)
        if kind == "range":
            return Normalize(low, high if high > low else low + 1.0, clip=True)
        return Normalize(0.0, 1.0 if kind == "share" else round_up(high), clip=True)

    def shown(self):
        """The part of the colours that the bar shows: of a signed scale not what the run does not reach."""
        norm = self.norm()
        if not self.is_signed:
            return norm.vmin, norm.vmax
        least = 0.05 * norm.vmax if self.quantity.kind == "signed log" else 0.1 * norm.vmax
        below, above = (min(round_up(end), norm.vmax) if end > 0.0 else 0.0 for end in (-self.low, self.high))
        return -max(below, least), max(above, least)

    def colour_map(self):
        return COLOURS["fast" if self.quantity.kind == "any" and not self.is_signed else self.quantity.colours]

    def colours(self, snapshot):
        """[n, 4] of the elements; nothing where there is no value."""
        values = values_of(self.quantity, snapshot)
        colours = self.colour_map()(self.norm()(np.nan_to_num(values)))
        colours[~np.isfinite(values), 3] = 0.0
        return colours


def colours_of_bodies(bodies):
    """Name -> RGB of each body."""
    return {name: np.array(matplotlib.colors.to_rgb(BODY_COLOURS[number % len(BODY_COLOURS)]))
            for number, name in enumerate(bodies)}


def told_apart(run, snapshot):
    """Whether the elements know which body they are of."""
    return bool(snapshot.body_shares(run.bodies).any())


def paint_bodies(run, snapshot):
    """[n, 4]: by the shares of the bodies; the thinner the paler, over four powers of ten."""
    palette = np.array(list(colours_of_bodies(run.bodies).values())).reshape(-1, 3)
    shares = snapshot.body_shares(run.bodies)
    whole = shares.sum(axis=1, keepdims=True)
    rgb = np.where(whole > 0, shares @ palette / np.maximum(whole, 1e-12), 0.45)
    solid = np.clip(snapshot.array("solid_fraction"), 1e-4, 1.0)
    return np.hstack([rgb, np.clip(1.0 + 0.19 * np.log10(solid), 0.25, 1.0)[:, None]])


def scales_of(names, snapshots, extremes_of):
    """Name -> scale over all snapshots. EXTREMES_OF(quantity): [(least, largest)] of each of them. Errors: whipple.Unknown."""
    found = {}
    for name in names:
        quantity = quantity_of(name, snapshots[-1])
        pairs = extremes_of(quantity)
        found[name] = Scale(quantity, min(low for low, _ in pairs), max(high for _, high in pairs))
    return found
