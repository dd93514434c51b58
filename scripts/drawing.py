# SPDX-License-Identifier: LGPL-2.1-or-later
"""How elements are drawn. Needs python3-matplotlib."""
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection


def draw(axes, corners, values, norm, colours):
    """Elements coloured by a value each; edges in their own colour so that no seams show."""
    shapes = PolyCollection(corners, array=values, norm=norm, cmap=colours, edgecolors="face", linewidths=0.2)
    axes.add_collection(shapes)
    return shapes


def shrunk(corners, solid):
    """Elements shrunk about their middle to the share of them that is solid: c = solid^(1/2), equation (10) of
    [Fahrenthold1993]."""
    middle = corners.mean(axis=1, keepdims=True)
    return middle + np.sqrt(np.clip(solid, 0.0, 1.0))[:, None, None] * (corners - middle)


def outline(corners, inside):
    """Line segments between what is inside and what is not, of square cells of a fixed mesh: [n, 2, 2]."""
    cells = np.asarray(corners)[np.asarray(inside, dtype=bool)]
    if len(cells) == 0:
        return np.empty((0, 2, 2))
    low, high = cells.min(axis=1), cells.max(axis=1)
    step = (high - low).min()
    base = low.min(axis=0)
    first, last = np.rint((low - base) / step).astype(int), np.rint((high - base) / step).astype(int)
    sides = {}  # unit edges: (axis along, i, j) -> how often
    for (i0, j0), (i1, j1) in zip(first, last):
        for i in range(i0, i1):
            for j in (j0, j1):
                sides[0, i, j] = sides.get((0, i, j), 0) + 1
        for j in range(j0, j1):
            for i in (i0, i1):
                sides[1, i, j] = sides.get((1, i, j), 0) + 1
    lonely = np.array([key for key, count in sides.items() if count == 1])
    start = base + step * lonely[:, 1:]
    along = np.where(lonely[:, :1] == 0, [[1.0, 0.0]], [[0.0, 1.0]])
    return np.stack([start, start + step * along], axis=1)


def draw_lines(axes, segments, colour, width=0.6):
    axes.add_collection(LineCollection(segments, colors=colour, linewidths=width))
