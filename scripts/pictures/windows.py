# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which part of the scene a picture shows: what matters at its time.

On a fixed mesh all pictures of a stage have one window: it holds what moves, as far as it is beside the plate. In flight the window
goes with the debris and grows as the cloud does. All windows are square.
"""
from dataclasses import dataclass

import numpy as np

MOVES = 0.02  # of the fastest speed
MARGIN = 1.12


@dataclass(frozen=True)
class Window:
    """cm. Axisymmetric ones begin at the axis; what they show is mirrored."""

    x_min: float
    x_max: float
    z_min: float
    z_max: float

    @property
    def whole(self):
        return (self.x_min, self.x_max, self.z_min, self.z_max)

    def holds(self, z):
        return self.z_min < z < self.z_max


def masses(snapshot, planar):
    """Of the elements (of one radian, or per cm)."""
    corners = snapshot.corners
    x, z = corners[..., 0], corners[..., 1]
    area = 0.5 * np.abs((x[:, 2] - x[:, 0]) * (z[:, 3] - z[:, 1]) - (x[:, 3] - x[:, 1]) * (z[:, 2] - z[:, 0]))
    return area * snapshot.array("density") * (1.0 if planar else np.abs(x).mean(axis=1))


def quantiles(values, weights, parts):
    order = np.argsort(values)
    share = np.cumsum(weights[order])
    return values[order][np.minimum(np.searchsorted(share, np.array(parts) * share[-1]), len(order) - 1)]


def extent(snapshot, planar):
    """x_min, x_max, z_min, z_max of what moves, but for a hundredth of its mass each way; of everything if nothing moves."""
    speed = snapshot.field("speed").values
    weights = masses(snapshot, planar)
    moving = (speed > MOVES * speed.max()) & (weights > 0.0)
    if not moving.any() or speed.max() <= 0.0:
        moving = np.ones(len(snapshot), dtype=bool)
        weights = np.maximum(weights, 1e-300)
    centres, weights = snapshot.centres[moving], weights[moving]
    x = quantiles(centres[:, 0], weights, [0.01, 0.99]) if planar else [0.0, quantiles(centres[:, 0], weights, [0.985])[0]]
    return (*x, *quantiles(centres[:, 1], weights, [0.005, 0.995]))


def square(x_min, x_max, z_min, z_max, planar):
    """The square window around a rectangle. Axisymmetric: its width is mirrored."""
    half = 0.5 * (1.4 if planar else MARGIN) * max(x_max - x_min if planar else 2.0 * x_max, z_max - z_min)
    z = 0.5 * (z_min + z_max)
    x = 0.5 * (x_min + x_max)
    return Window(x - half if planar else 0.0, x + half if planar else half, z - half, z + half)


def of_a_fixed_mesh(extents, plates, planar):
    """One for all written times of a stage. A long cloud that comes in is shown only as far as it is wide, before the plate."""
    extents = np.array(extents)
    x_min, z_min = extents[:, [0, 2]].min(axis=0)
    x_max, z_max = extents[:, [1, 3]].max(axis=0)
    width = x_max - x_min if planar else 2.0 * x_max
    near = [plate for plate in plates if z_min - width < plate.front < z_max + width]
    if near and z_max - z_min > 0.9 * width:
        plate = near[-1]
        z_min = max(z_min, plate.front - 0.65 * width)
        z_max = max(z_max, plate.rear + 0.2 * width)
    return square(x_min, x_max, z_min, z_max, planar)


def windows_of(run, extents):
    """Window of each written time. EXTENTS: extent() of each."""
    found, start = [], 0
    for stage, group in run.stages():
        of_stage = extents[start:start + len(group)]
        if run.is_moving(stage):
            found += [square(*one, run.is_planar) for one in of_stage]
        else:
            there = [plate for plate in run.plates if plate.name in introduced(run, stage)]
            found += [of_a_fixed_mesh(of_stage, there, run.is_planar)] * len(group)
        start += len(group)
    return found


def introduced(run, stage):
    return [name.strip() for name in run.parameters.get(f"Stages/{stage}/Introduces", "").split(",")]


def around(corners, margin, planar):
    """The rectangle that holds these elements, and a margin, as a share of its height."""
    points = np.asarray(corners).reshape(-1, 2)
    z_min, z_max = points[:, 1].min(), points[:, 1].max()
    extra = margin * (z_max - z_min)
    return Window(points[:, 0].min() - extra if planar else 0.0, points[:, 0].max() + extra, z_min - extra, z_max + extra)


def whole_scene(run, extents):
    """Rectangle of all that ever matters, plates included, for the overview."""
    extents = np.array(extents)
    x_min, z_min = extents[:, [0, 2]].min(axis=0)
    x_max, z_max = extents[:, [1, 3]].max(axis=0)
    for plate in run.plates:
        z_min, z_max = min(z_min, plate.front), max(z_max, plate.rear)
    extra = 0.04 * (z_max - z_min)
    return Window(x_min - extra if run.is_planar else 0.0, x_max + extra, z_min - extra, z_max + extra)


def of_both(one, other):
    """The square window that holds two."""
    if one == other:
        return one
    x_min, x_max = min(one.x_min, other.x_min), max(one.x_max, other.x_max)
    z_min, z_max = min(one.z_min, other.z_min), max(one.z_max, other.z_max)
    planar = one.x_min != 0.0 or other.x_min != 0.0
    half = 0.5 * max(x_max - x_min if planar else 2.0 * x_max, z_max - z_min)
    x, z = 0.5 * (x_min + x_max), 0.5 * (z_min + z_max)
    return Window(x - half if planar else 0.0, x + half if planar else half, z - half, z + half)
