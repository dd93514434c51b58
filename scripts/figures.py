# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of a chain of stages: the hand-overs in pairs, the moments of the paper's figures, a strip of all stages.

Our copy of [Fahrenthold1993] has lost its captions. Its figures 2 and 3 have twelve parts and its case four gaps, so we take
three of each gap: the debris as it is taken over, at the end of its flight, and laid down before the next plate. Figure 4 is the
wall at the end. Of other scenes likewise: 2a to 2f, 3a to 3f ... for as many gaps as there are, and the next number.

Elements are drawn twice: on the right as they are, coloured by density; on the left as what is solid in them. An element that is
a third solid is drawn as a third of itself: dust is a cloud of points, a fragment is solid. On a fixed mesh the line around all that
is more than half solid is drawn too. Needs python3-matplotlib and python3-h5py.
"""
import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm, Normalize

from drawing import draw, draw_lines, outline, shrunk
from run_fields import stages, window_of
from run_record import Unknown, plates

LETTERS = "abcdef"  # of one figure: two gaps
DENSEST = 3.0  # g/cm^3, of the colours


def is_moving(values, stage):
    return values.get(f"Stages/{stage}/Mode") == "lagrangian"


def moments(times, values):
    """Name of each figure -> (snapshot, what it shows, snapshot of the debris whose surroundings are shown)."""
    groups = stages(times)
    found, gaps = {}, 0
    for number, (name, group) in enumerate(groups):
        if not is_moving(values, name):
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


def handovers(times, values):
    """Of each change of stage the states on both sides of it."""
    groups = stages(times)
    for (name, group), (after, next_group) in zip(groups[:-1], groups[1:]):
        debris = next_group[0] if is_moving(values, after) else group[-1]
        yield group[-1], next_group[0], debris


def half_and_half(axes, snapshot, values, window, planar):
    """Solid on the left, elements by density on the right."""
    r_max, z_min, z_max = window
    corners, fields = snapshot.corners, snapshot.fields
    seen = (corners[..., 1].max(axis=1) > z_min) & (corners[..., 1].min(axis=1) < z_max)
    seen &= corners[..., 0].min(axis=1) < r_max
    corners, solid = corners[seen], fields["solid_fraction"][seen]
    density = np.maximum(fields["density"][seen], 1e-12)
    shapes = draw(axes, corners, density, LogNorm(1e-4 * DENSEST, DENSEST), "viridis_r")
    if not planar:
        black = draw(axes, shrunk(corners, solid) * [-1.0, 1.0], np.ones(len(corners)), Normalize(0.0, 1.0), "gray_r")
        black.set_linewidth(0.0)
        axes.axvline(0.0, color="0.6", linewidth=0.5)
    if not is_moving(values, snapshot.stage):
        lines = outline(corners, solid > 0.5)
        draw_lines(axes, lines, "k")
        if not planar:
            draw_lines(axes, lines * [-1.0, 1.0], "k", 0.3)
    axes.set(xlim=(0.0 if planar else -r_max, r_max), ylim=(z_min, z_max), aspect="equal",
             xlabel="x, cm" if planar else "r, cm", ylabel="y, cm" if planar else "z, cm")
    return shapes


def surroundings(debris, values):
    """Window that shows the debris and the plates near it."""
    if is_moving(values, debris.stage):
        r_max, z_min, z_max = window_of(debris.corners, 0.1)
    else:  # the end: the last plate and as much around it
        _, front, thickness = plates(values)[-1] if plates(values) else ("", 0.0, 1.0)
        dense = debris.corners[debris.fields["solid_fraction"] > 0.5].reshape(-1, 2)
        size = 12.0 * thickness
        near = dense[np.abs(dense[:, 1] - front - 0.5 * thickness) < size]
        z_min = min(front - size, near[:, 1].min() if len(near) else front)
        z_max = max(front + thickness + size, near[:, 1].max() if len(near) else front)
        r_max = size
    for _, front, thickness in plates(values):
        if z_max < front + thickness < z_max + 0.15 * (z_max - z_min):
            z_max = front + thickness + 0.02 * (z_max - z_min)
    return r_max, z_min, z_max


def save(figure, shapes, axes, path):
    figure.colorbar(shapes, ax=axes, label="density, g/cm$^3$", shrink=0.8)
    figure.savefig(path, dpi=130, bbox_inches="tight")
    plt.close(figure)
    return path


def size_of(window, panels, planar, height=6.0):
    r_max, z_min, z_max = window
    width = np.clip(height * (1 if planar else 2) * r_max / (z_max - z_min), 2.5, 9.0)
    return panels * width + 1.8, height


def one(name, moment, values, folder, planar):
    snapshot, words, debris = moment
    window = surroundings(debris, values)
    figure, axes = plt.subplots(figsize=size_of(window, 1, planar), layout="constrained")
    shapes = half_and_half(axes, snapshot, values, window, planar)
    axes.set_title(f"{name}: {snapshot.stage}, {words}\n{snapshot.time:.2f} us")
    return save(figure, shapes, axes, os.path.join(folder, f"figure-{name}.png"))


def pair(number, before, after, debris, values, folder, planar):
    window = surroundings(debris, values)
    figure, panels = plt.subplots(1, 2, figsize=size_of(window, 2, planar), layout="constrained")
    for axes, snapshot in zip(panels, (before, after)):
        shapes = half_and_half(axes, snapshot, values, window, planar)
        axes.set_title(f"{snapshot.stage}, {len(snapshot.corners)} elements")
    figure.suptitle(f"hand-over {number} at {after.time:.2f} us")
    return save(figure, shapes, panels, os.path.join(folder, f"handover-{number}.png"))


def by_name(name, times, values, folder, planar):
    """Draw figures; yields their paths. @raise Unknown if there is none of this name"""
    known = moments(times, values)
    if name not in ("all", "handovers", *known):
        raise Unknown(f"has no figure '{name}'; it has: all, handovers, {', '.join(known)}")
    if name in ("all", "handovers"):
        for number, (before, after, debris) in enumerate(handovers(times, values), 1):
            yield pair(number, before, after, debris, values, folder, planar)
    for figure, moment in known.items():
        if name in ("all", figure):
            yield one(figure, moment, values, folder, planar)


def strip(times, values, folder, planar):
    """The end of every stage side by side, coloured by axial velocity; yields the path."""
    groups = stages(times)
    ends = [group[-1] for _, group in groups]
    moving = [s for s in ends if is_moving(values, s.stage)] or ends
    r_max = 1.15 * max(s.corners[..., 0].max() for s in moving)
    z_min = min(s.corners[..., 1].min() for s in moving + ends[:1])
    z_max = max(s.corners[..., 1].max() for s in ends)
    for _, front, thickness in plates(values):
        z_max = max(z_max, front + thickness)
    z_min, z_max = z_min - 0.03 * (z_max - z_min), z_max + 0.03 * (z_max - z_min)
    fastest = 10.0 * max(np.abs(s.axial_velocity).max() for s in ends)
    height = 9.0
    width = np.clip(height * (1 if planar else 2) * r_max / (z_max - z_min), 0.8, 4.0)
    figure, panels = plt.subplots(1, len(ends), figsize=(len(ends) * width + 1.0, height), sharey=True, squeeze=False,
                                  layout="constrained")
    for axes, snapshot in zip(panels[0], ends):
        for _, front, thickness in plates(values):
            axes.axhspan(front, front + thickness, color="0.85", linewidth=0)
        solid = shrunk(snapshot.corners, snapshot.fields["solid_fraction"])
        speed = 10.0 * snapshot.axial_velocity
        for side in ([1.0, 1.0],) if planar else ([1.0, 1.0], [-1.0, 1.0]):
            draw(axes, snapshot.corners * side, speed, Normalize(0.0, fastest), "plasma").set_alpha(0.25)
            shapes = draw(axes, solid * side, speed, Normalize(0.0, fastest), "plasma")
        axes.set(xlim=(0.0 if planar else -r_max, r_max), ylim=(z_min, z_max), aspect="equal",
                 xlabel="x, cm" if planar else "r, cm")
        axes.set_title(f"{snapshot.stage}\n{snapshot.time:.2f} us", fontsize=8)
    panels[0][0].set_ylabel("y, cm" if planar else "z, cm")
    figure.colorbar(shapes, ax=panels, label="axial velocity, km/s", shrink=0.6)
    path = os.path.join(folder, "strip.png")
    figure.savefig(path, dpi=150, bbox_inches="tight")
    plt.close(figure)
    yield path
