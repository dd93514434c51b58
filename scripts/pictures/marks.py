# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is written on a panel: scale bar, plates, hole and crater with their numbers."""
import matplotlib.patheffects as effects
import numpy as np
from matplotlib.patches import Rectangle

from .quantities import colours_of_bodies

HALO = [effects.withStroke(linewidth=2.5, foreground="white", alpha=0.85)]
SHOWN = ("perforated", "hole_diameter_cm", "crater_depth_cm", "perforation_margin_cm")


def scale_bar(axes, window):
    """A length of 1, 2 or 5 times a power of ten, about a fifth of the width."""
    width = window.z_max - window.z_min
    power = 10.0**np.floor(np.log10(0.25 * width))
    length = max(step * power for step in (1.0, 2.0, 5.0) if step * power <= 0.25 * width)
    right, bottom = window.x_max - 0.04 * width, window.z_min + 0.035 * width
    axes.plot([right - length, right], [bottom, bottom], color="k", linewidth=3, solid_capstyle="butt", path_effects=HALO)
    text = f"{length:g} cm" if length >= 0.1 else f"{10 * length:g} mm" if length >= 0.01 else f"{1e4 * length:g} um"
    axes.text(right - 0.5 * length, bottom + 0.012 * width, text, ha="center", va="bottom", fontsize=9, path_effects=HALO)


def measured(run, snapshot):
    """Plate -> its results at this time: of the history if the run has one, else where they were measured."""
    found = {}
    for plate in run.plates:
        table = run.summary_or_none["results"].get(plate.name, {}) if run.summary_or_none else {}
        at = table.get("measured_at_us")
        if at is not None and abs(at - snapshot.time) <= 1e-5 * max(at, 1e-3) and not run.is_moving(snapshot.stage):
            found[plate.name] = {key: table.get(key) for key in SHOWN}
        elif run.history is not None:
            of_plate = at_time(run.history, plate.name, snapshot.time)
            if of_plate and not run.is_moving(snapshot.stage):
                found[plate.name] = of_plate
    return found


def at_time(history, plate, time):
    """Results of the last row up to a time, if it is not from long before."""
    times = history["time_us"]
    row = np.searchsorted(times, time * (1.0 + 1e-6), side="right") - 1
    step = np.median(np.diff(times)) if len(times) > 1 else 0.0
    if row < 0 or time - times[row] > 3.0 * step + 1e-9:
        return {}
    found = {key: history[f"{plate} {key}"][row] for key in SHOWN if f"{plate} {key}" in history}
    return {key: float(value) for key, value in found.items() if np.isfinite(float(value))}


def words_of(name, result):
    """One line about a plate: its verdict, hole or crater."""
    hole, crater, margin = (result.get(key) for key in ("hole_diameter_cm", "crater_depth_cm", "perforation_margin_cm"))
    if hole:
        return f"{name}: hole {hole:.3g} cm"
    if crater is None:
        return f"{name}: not measured"
    left = f", {-margin:.3g} cm left" if margin is not None and margin < 0.0 else ""
    return f"{name}: holds, crater {crater:.2g} cm{left}"


def arrow(axes, start, end):
    axes.annotate("", xy=end, xytext=start, arrowprops={"arrowstyle": "<->", "color": "k", "linewidth": 1.1, "shrinkA": 0, "shrinkB": 0,
                                                        "path_effects": HALO})


def hole_and_crater(axes, plate, result, window):
    """An arrow across the hole, or into the crater, and its number; axisymmetric scenes, where both are at the axis."""
    hole, crater = result.get("hole_diameter_cm"), result.get("crater_depth_cm")
    middle, width = plate.front + 0.5 * plate.thickness, window.z_max - window.z_min
    if hole and hole < 1.9 * window.x_max:
        arrow(axes, (-0.5 * hole, middle), (0.5 * hole, middle))
        axes.text(0.0, middle - 0.015 * width, f"hole {hole:.3g} cm", ha="center", va="top", fontsize=9, path_effects=HALO, zorder=5)
    elif crater and crater > 0.02 * width:
        arrow(axes, (0.0, plate.front), (0.0, plate.front + crater))
        axes.text(0.02 * width, plate.front + 0.5 * crater, f"crater {crater:.2g} cm", ha="left", va="center", fontsize=9,
                  path_effects=HALO)


def is_there(snapshot, run, plate):
    """Whether the elements hold the plate: it has entered, and has not been left behind at a hand-over."""
    if run.is_moving(snapshot.stage):
        return False
    centres, solid = snapshot.centres[:, 1], snapshot.array("solid_fraction") > 0.5
    return bool((solid & (centres > plate.front) & (centres < plate.rear)).any())


def name_plates(axes, run, snapshot, window):
    """Names at the right; a plate that is not there only as its outline."""
    width = window.z_max - window.z_min
    for plate in run.plates:
        if not window.holds(plate.front + 0.5 * plate.thickness):
            continue
        there = is_there(snapshot, run, plate)
        if not there:
            left = window.x_min if run.is_planar else -window.x_max
            axes.plot([left, window.x_max, np.nan, left, window.x_max], [plate.front, plate.front, np.nan, plate.rear, plate.rear],
                      color="0.5", linewidth=0.6, dashes=(6, 4))
        above = plate.rear + 0.05 * width < window.z_max
        axes.text(window.x_max - 0.02 * width, plate.rear + 0.01 * width if above else plate.front - 0.01 * width, plate.name, ha="right",
                  va="bottom" if above else "top", fontsize=9, path_effects=HALO,
                  color=tuple(0.75 * colours_of_bodies(run.bodies)[plate.name]) if there else "0.4")


def body_key(axes, bodies):
    """Which colour is which body, in axes of their own."""
    axes.set_axis_off()
    axes.set(xlim=(0.0, 10.0), ylim=(len(bodies), 0.0))
    for number, (name, colour) in enumerate(colours_of_bodies(bodies).items()):
        axes.add_patch(Rectangle((0.0, number + 0.15), 1.2, 0.7, facecolor=colour, edgecolor="0.2", linewidth=0.5))
        axes.text(1.7, number + 0.5, name, fontsize=8.5, va="center")


def mark(axes, run, snapshot, window):
    """All of it."""
    scale_bar(axes, window)
    name_plates(axes, run, snapshot, window)
    if not run.is_planar:
        results = measured(run, snapshot)
        for plate in run.plates:
            if plate.name in results and window.holds(plate.front + 0.5 * plate.thickness):
                hole_and_crater(axes, plate, results[plate.name], window)
