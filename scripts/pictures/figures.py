# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of a chain of stages: the hand-overs in pairs, the moments of the paper's figures, a strip of all stages.

Our copy of [Fahrenthold1993] has lost its captions. Its figures 2 and 3 have twelve parts and its case four gaps, so we take
three of each gap: the debris as it is taken over, at the end of its flight, and laid down before the next plate. Figure 4 is the
wall at the end. Of other scenes likewise: 2a to 2f, 3a to 3f ... for as many gaps as there are, and the next number.

Elements are drawn twice: on the right as they are, coloured by density; on the left as what is solid in them. An element that is
a third solid is drawn as a third of itself: dust is a cloud of points, a fragment is solid. On a fixed mesh the line around all that
is more than half solid is drawn too. Needs python3-matplotlib and python3-h5py.
"""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LogNorm, Normalize

from whipple import Unknown
from whipple.snapshot import by_stage

from .panel import LINE, put
from .quantities import BACKGROUND, COLOURS
from .raster import FINER, borders, coarser, cover, paint, shrunk
from .windows import Window, around

LETTERS = "abcdef"  # of one figure: two gaps
DENSE, NORM = COLOURS["dense"], LogNorm(3e-4, 3.0, clip=True)  # g/cm^3
DPI = 130


def moments(run):
    """Name of each figure -> (snapshot, what it shows, snapshot of the debris whose surroundings are shown)."""
    groups = run.stages()
    found, gaps = {}, 0
    for number, (name, group) in enumerate(groups):
        if not run.is_moving(name):
            continue
        figure, letters = 2 + gaps // 2, LETTERS[3 * (gaps % 2):]
        found[f"{figure}{letters[0]}"] = (group[0], "taken over", group[0])
        found[f"{figure}{letters[1]}"] = (group[-1], "at the end of its flight", group[-1])
        if number + 1 < len(groups):
            landed = groups[number + 1][1][0]
            found[f"{figure}{letters[2]}"] = (landed, "laid down", group[-1])
        gaps += 1
    end = groups[-1][1][-1]
    found[str(2 + (gaps + 1) // 2)] = (end, "at the end", end)
    return found


def handovers(run):
    """Of each change of stage the states on both sides of it."""
    groups = run.stages()
    for (name, group), (after, next_group) in zip(groups[:-1], groups[1:]):
        debris = next_group[0] if run.is_moving(after) else group[-1]
        yield group[-1], next_group[0], debris


def painted(corners, colours, window, shape):
    return paint(cover(corners, window.whole, shape), colours, BACKGROUND)


def half_and_half(axes, run, snapshot, window):
    """Solid on the left, elements by density on the right. On a fixed mesh with a line around what is more than half solid."""
    rows, columns = pixels_of(window)
    shape = rows * FINER, columns * FINER
    corners, solid = snapshot.corners, snapshot.array("solid_fraction")
    picture = painted(corners, DENSE(NORM(snapshot.array("density"))), window, shape)
    lines = np.zeros((rows, columns, 1))
    if not run.is_moving(snapshot.stage):
        lines = coarser(borders(np.append(solid > 0.5, False)[cover(corners, window.whole, shape)]))[..., None]
    picture = picture * (1.0 - lines) + LINE * lines
    if not run.is_planar:
        black = np.tile([*LINE, 1.0], (len(corners), 1))
        left = painted(shrunk(corners, solid), black, window, shape)
        picture = np.hstack([(left * (1.0 - lines) + LINE * lines)[:, ::-1], picture])
    put(axes, run, window, picture)


def surroundings(debris, run):
    """Window that shows the debris and the plates near it."""
    if run.is_moving(debris.stage):
        window = around(debris.corners, 0.1, run.is_planar)
        x_min, x_max, z_min, z_max = window.whole
    else:  # the end: the last plate and as much around it
        front, thickness = (run.plates[-1].front, run.plates[-1].thickness) if run.plates else (0.0, 1.0)
        dense = debris.corners[debris.array("solid_fraction") > 0.5].reshape(-1, 2)
        size = 12.0 * thickness
        near = dense[np.abs(dense[:, 1] - front - 0.5 * thickness) < size]
        z_min = min(front - size, near[:, 1].min() if len(near) else front)
        z_max = max(front + thickness + size, near[:, 1].max() if len(near) else front)
        x_min, x_max = -size if run.is_planar else 0.0, size
    for plate in run.plates:
        if z_max < plate.rear < z_max + 0.15 * (z_max - z_min):
            z_max = plate.rear + 0.02 * (z_max - z_min)
    return Window(x_min, x_max, z_min, z_max)


HEIGHT = 6.0  # inches, of a panel


def across(window):
    """Width of a panel over its height."""
    return (window.x_max - window.x_min) * (1.0 if window.x_min else 2.0) / (window.z_max - window.z_min)


def pixels_of(window, height=HEIGHT):
    """Rows and columns of one half of a panel."""
    rows = int(height * DPI)
    return rows, max(int(rows * (window.x_max - window.x_min) / (window.z_max - window.z_min)), 1)


def save(figure, bar, label, axes, path):
    figure.colorbar(bar, ax=axes, label=label, shrink=0.8).minorticks_off()
    figure.savefig(path, dpi=DPI, bbox_inches="tight")
    plt.close(figure)
    return path


def panels_of(count, window):
    width = np.clip(HEIGHT * across(window), 2.5, 9.0)
    figure, axes = plt.subplots(1, count, figsize=(count * width + 1.8, HEIGHT), layout="constrained", squeeze=False)
    return figure, list(axes[0])


DENSITY = ScalarMappable(NORM, DENSE), "density, g/cm$^3$"


def one(name, moment, run, path):
    snapshot, words, debris = moment
    window = surroundings(debris, run)
    figure, (axes,) = panels_of(1, window)
    half_and_half(axes, run, snapshot, window)
    axes.set_title(f"{name}: {snapshot.stage}, {words}\n{snapshot.time:.2f} us")
    return save(figure, *DENSITY, axes, path)


def pair(number, before, after, debris, run, path):
    window = surroundings(debris, run)
    figure, panels = panels_of(2, window)
    for axes, snapshot in zip(panels, (before, after)):
        half_and_half(axes, run, snapshot, window)
        axes.set_title(f"{snapshot.stage}, {len(snapshot)} elements")
    figure.suptitle(f"hand-over {number} at {after.time:.2f} us")
    return save(figure, *DENSITY, panels, path)


def by_name(name, run):
    """[(file name, what draws it, its arguments)] of figures. Errors: whipple.Unknown if there is none of this name."""
    known = moments(run)
    if name not in ("all", "handovers", *known):
        raise Unknown(f"has no figure '{name}'; it has: all, handovers, {', '.join(known)}")
    jobs = []
    if name in ("all", "handovers"):
        for number, (before, after, debris) in enumerate(handovers(run), 1):
            jobs.append((f"handover-{number}", pair, (number, before, after, debris, run)))
    return jobs + [(f"figure-{figure}", one, (figure, moment, run)) for figure, moment in known.items() if name in ("all", figure)]


def strip_window(run, ends):
    moving = [s for s in ends if run.is_moving(s.stage)] or ends
    x_max = 1.15 * max(s.corners[..., 0].max() for s in moving)
    x_min = min(s.corners[..., 0].min() for s in moving) if run.is_planar else 0.0
    z_min = min(s.corners[..., 1].min() for s in moving + ends[:1])
    z_max = max([*(s.corners[..., 1].max() for s in ends), *(plate.rear for plate in run.plates)])
    extra = 0.03 * (z_max - z_min)
    return Window(x_min, x_max, z_min - extra, z_max + extra)


def strip_panel(axes, run, snapshot, window, norm):
    """By axial velocity: elements pale, what is solid in them over it."""
    rows, columns = pixels_of(window, STRIP_HEIGHT)
    shape = rows * FINER, columns * FINER
    colours = FAST(norm(10.0 * snapshot.velocity[:, 1]))  # cm/us -> km/s
    pale = colours * [1.0, 1.0, 1.0, 0.55]
    solid = cover(shrunk(snapshot.corners, snapshot.array("solid_fraction")), window.whole, shape)
    whole = cover(snapshot.corners, window.whole, shape)
    picture = paint(np.where(solid >= 0, solid, np.where(whole >= 0, whole + len(colours), -1)), np.vstack([colours, pale]), BACKGROUND)
    put(axes, run, window, picture if run.is_planar else np.hstack([picture[:, ::-1], picture]))
    for plate in run.plates:
        axes.axhspan(plate.front, plate.rear, facecolor="none", edgecolor="0.5", linewidth=0.5)


STRIP_HEIGHT = 9.0
FAST = COLOURS["fast"]


def strip(run, path):
    """The end of every stage side by side, coloured by axial velocity."""
    ends = [group[-1] for _, group in by_stage(run.snapshots)]
    window = strip_window(run, ends)
    norm = Normalize(0.0, 10.0 * max(s.velocity[:, 1].max() for s in ends) or 1.0, clip=True)
    width = np.clip(STRIP_HEIGHT * across(window), 0.8, 4.0)
    figure, panels = plt.subplots(1, len(ends), figsize=(len(ends) * width + 1.0, STRIP_HEIGHT), sharey=True, squeeze=False,
                                  layout="constrained")
    for axes, snapshot in zip(panels[0], ends):
        strip_panel(axes, run, snapshot, window, norm)
        axes.set_title(f"{snapshot.stage}\n{snapshot.time:.2f} us", fontsize=8)
        axes.set_ylabel("")
    panels[0][0].set_ylabel("y, cm" if run.is_planar else "z, cm")
    return save(figure, ScalarMappable(norm, FAST), "axial velocity, km/s", panels, path)
