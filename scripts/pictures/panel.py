# SPDX-License-Identifier: LGPL-2.1-or-later
"""One panel: the elements of a written time in a window, mirrored about the axis where the scene is axisymmetric."""
import numpy as np

from .quantities import BACKGROUND, paint_bodies
from .raster import FINER, borders, coarser, cover, paint

LINE = np.array([0.12, 0.12, 0.14])


def element_colours(name, run, snapshot, scales):
    return paint_bodies(run, snapshot) if name == "bodies" else scales[name].colours(snapshot)


def outlines(run, snapshot, image):
    """Around what is more than half solid, and between bodies."""
    shares = snapshot.body_shares(run.bodies)
    kinds = np.where(snapshot.array("solid_fraction") > 0.5, 1 + shares.argmax(axis=1), 0) if shares.size else np.zeros(len(snapshot))
    return borders(np.append(kinds, 0)[image])


def mesh_lines(snapshot, image):
    """Between elements that are some pixels wide."""
    counts = np.bincount(image[image >= 0].ravel(), minlength=len(snapshot))
    wide = np.append(counts >= (3 * FINER)**2 / 2, False)
    return borders(image) & wide[image]


def half(name, run, snapshot, scales, image):
    """Picture of a raster by one quantity."""
    picture = paint(image, element_colours(name, run, snapshot, scales), BACKGROUND)
    lines, strength = (mesh_lines(snapshot, image), 0.75) if name == "mesh" else (outlines(run, snapshot, image), 0.55)
    share = strength * coarser(lines)[..., None]
    return picture * (1.0 - share) + LINE * share


def picture_of(run, snapshot, window, names, scales, pixels):
    """RGB, rows from the bottom, of (right, left) by name: axisymmetric. Planar: of the first name alone.

    pixels: (columns, rows) of the whole."""
    columns, rows = pixels
    width = columns if run.is_planar else columns // 2
    image = cover(snapshot.corners, window.whole, (rows * FINER, width * FINER))
    right = half(names[0], run, snapshot, scales, image)
    if run.is_planar:
        return right
    left = right if names[1] == names[0] else half(names[1], run, snapshot, scales, image)
    return np.hstack([left[:, ::-1], right])


def show(axes, run, snapshot, window, names, scales, pixels):
    """Draw it, with its axes."""
    put(axes, run, window, picture_of(run, snapshot, window, names, scales, pixels))


def put(axes, run, window, picture):
    """A picture of a window, with its axes."""
    left = window.x_min if run.is_planar else -window.x_max
    axes.imshow(np.rint(255.0 * picture).astype(np.uint8), origin="lower", interpolation="nearest",
                extent=(left, window.x_max, window.z_min, window.z_max))
    axes.set(xlim=(left, window.x_max), ylim=(window.z_min, window.z_max), aspect="equal",
             xlabel="x, cm" if run.is_planar else "r, cm", ylabel="y, cm" if run.is_planar else "z, cm")
    axes.tick_params(labelsize=8, direction="out")
    if not run.is_planar:
        axes.axvline(0.0, color="0.35", linewidth=0.5, dashes=(8, 3, 2, 3))
