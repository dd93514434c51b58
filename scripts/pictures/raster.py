# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elements on the pixels of a picture: which element covers each pixel, found with arrays, whatever the mesh.

A pixel is covered if its middle is inside. In a row of pixels a convex element reaches from its leftmost to its rightmost edge on
the row's middle line; squares of an adaptive mesh and deformed elements go the same way. An element so small that it has the
middle of no pixel gets the one it is in, unless another has it: fragments do not vanish.
"""
import numpy as np

FINER = 2  # pixels of the raster for one of the picture, along each axis
ROWS_AT_A_TIME = 400000


def spans(points, rows, columns):
    """(element, row, first and last + 1 pixel) of elements with corners in pixels, pixel middles at whole numbers."""
    low = np.clip(np.ceil(points[..., 1].min(axis=1)), 0, rows).astype(int)
    high = np.clip(np.ceil(points[..., 1].max(axis=1)), 0, rows).astype(int)
    counts = np.maximum(high - low, 0)
    element = np.repeat(np.arange(len(points)), counts)
    row = np.repeat(low - np.cumsum(counts) + counts, counts) + np.arange(counts.sum())
    left, right = np.full(len(element), np.inf), np.full(len(element), -np.inf)
    for corner in range(4):
        start, end = points[element, corner], points[element, (corner + 1) % 4]
        rise = end[:, 1] - start[:, 1]
        part = np.divide(row - start[:, 1], rise, out=np.full(len(row), -1.0), where=rise != 0)
        x = start[:, 0] + part * (end[:, 0] - start[:, 0])
        crossed = (part >= 0.0) & (part <= 1.0)
        left = np.where(crossed, np.minimum(left, x), left)
        right = np.where(crossed, np.maximum(right, x), right)
    begin = np.clip(np.ceil(np.minimum(left, columns)), 0, columns).astype(int)
    stop = np.clip(np.ceil(np.maximum(right, 0)), 0, columns).astype(int)
    return element, row, begin, np.maximum(stop, begin)


def cover(corners, window, shape):
    """Number of the element on each pixel, -1 where there is none.

    corners: [n, 4, 2], cm; window: (x_min, x_max, z_min, z_max), cm; shape: rows (from z_min up) and columns."""
    rows, columns = shape
    x_min, x_max, z_min, z_max = window
    scale = [columns / (x_max - x_min), rows / (z_max - z_min)]
    points = (np.asarray(corners, dtype=float) - [x_min, z_min]) * scale - 0.5
    near = ((points.max(axis=1) > -0.5) & (points.min(axis=1) < [columns - 0.5, rows - 0.5])).all(axis=1)
    ids = np.flatnonzero(near)
    points = points[near]
    image = np.full(rows * columns, -1, dtype=np.int64)
    in_a_chunk = np.maximum(points[..., 1].max(axis=1) - points[..., 1].min(axis=1), 1.0)
    chunk = (np.cumsum(in_a_chunk) // ROWS_AT_A_TIME).astype(int) if len(points) else np.empty(0, dtype=int)
    for part in range(chunk.max() + 1 if len(chunk) else 0):
        of_part = np.flatnonzero(chunk == part)
        element, row, begin, stop = spans(points[of_part], rows, columns)
        counts = stop - begin
        within = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        image[np.repeat(row * columns + begin, counts) + within] = np.repeat(ids[of_part][element], counts)
    image = close_gaps(image.reshape(shape)).ravel()
    place_small(image, points, ids, shape)
    return image.reshape(shape)


def place_small(image, points, ids, shape):
    """A pixel for each element that has none, where nothing else is."""
    rows, columns = shape
    shown = np.zeros(ids.max() + 1 if len(ids) else 0, dtype=bool)
    shown[image[image >= 0]] = True
    small = np.flatnonzero(~shown[ids])
    middle = np.rint(points[small].mean(axis=1)).astype(int)
    inside = ((middle >= 0) & (middle < [columns, rows])).all(axis=1)
    pixel = middle[inside, 1] * columns + middle[inside, 0]
    free = image[pixel] < 0
    image[pixel[free]] = ids[small[inside][free]]


def shrunk(corners, solid):
    """Elements shrunk about their middle to the share of them that is solid: c = solid^(1/2), equation (10) of
    [Fahrenthold1993]."""
    middle = corners.mean(axis=1, keepdims=True)
    return middle + np.sqrt(np.clip(solid, 0.0, 1.0))[:, None, None] * (corners - middle)


def paint(image, colours, background):
    """RGB picture of a raster: colours [n, 4] of the elements over the background, FINER pixels each way made one."""
    table = np.empty((len(colours) + 1, 3), dtype=np.float32)
    alpha = colours[:, 3:4]
    table[:-1] = colours[:, :3] * alpha + np.asarray(background) * (1.0 - alpha)
    table[-1] = background  # -1
    return coarser(table[image])


def coarser(raster):
    """Means over FINER pixels each way."""
    total = sum(raster[i::FINER, j::FINER].astype(np.float32) for i in range(FINER) for j in range(FINER))
    return total / FINER**2


def close_gaps(image):
    """Cracks one pixel wide between elements, which are less than the raster resolves, take the element beside them."""
    for axis in (0, 1):
        before, after = np.roll(image, 1, axis), np.roll(image, -1, axis)
        gap = (image < 0) & (before >= 0) & (after >= 0)
        edge = [slice(None), slice(None)]
        for edge[axis] in (0, -1):
            gap[tuple(edge)] = False
        image = np.where(gap, before, image)
    return image


def borders(kinds):
    """Where a raster of kinds changes to the pixel above or on the right: lines around things."""
    lines = np.zeros(kinds.shape, dtype=bool)
    lines[:, :-1] |= kinds[:, 1:] != kinds[:, :-1]
    lines[:-1] |= kinds[1:] != kinds[:-1]
    return lines
