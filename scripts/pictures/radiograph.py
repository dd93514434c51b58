# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual flash radiograph: areal density of the elements of a run, seen from the side.

Axisymmetric: along a line at the distance x from the axis, in the plane of height z, a disc of radius r is
L(r, x) = 2 (r^2 - x^2)^(1/2) long (r > x), and an element at the height z is the difference of two discs. So by Green's
theorem the areal density of elements of density rho is the sum over their edges, taken counter-clockwise,

    a(x, z) = sum rho L(r(z), x) sign(dz)                    g/cm^2

Each pixel holds the mean over its width and height. Over x it is exact: int L dx = x (r^2 - x^2)^(1/2) + r^2 asin(x / r).
Over the height of a row an edge has one radius, the one with its mean r^2, so that the mass in a picture is exact, whatever
the shape of the elements. Planar: the mean density, per cm of depth. Needs python3-matplotlib.
"""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

from .marks import scale_bar
from .quantities import round_up

EDGES_AT_A_TIME = 20000
PIXELS = 400  # along the height of a picture
DECADES = 5


def disc_integral(r, x):
    """Integral of L(r, .) from 0 to x, for arrays r (n, 1) and x (1, m), x >= 0."""
    inside = np.minimum(x, r)
    return inside * np.sqrt(np.maximum(r * r - inside * inside, 0.0)) + r * r * np.arcsin(
        np.divide(inside, r, out=np.zeros_like(inside), where=r > 0))


def strip_integral(r, x):
    """The same of what is left of r in planar geometry: 1 up to r."""
    return np.minimum(x, r)


def pieces(corners, density, z_edges, planar):
    """Edges cut at the rows of the picture: row, radius, and density times the signed share of the row's height."""
    corners = np.array(corners, dtype=float)
    if not planar:
        corners[..., 0] = np.abs(corners[..., 0])  # what has crossed the axis is on its other side, the same ring
    ahead = np.roll(corners, -1, axis=1)
    turn = np.sign((corners[..., 0] * ahead[..., 1] - ahead[..., 0] * corners[..., 1]).sum(axis=1))
    weight = np.repeat(np.asarray(density, dtype=float) * turn, 4)
    start, end = corners.reshape(-1, 2), ahead.reshape(-1, 2)
    height = z_edges[1] - z_edges[0]
    low, high = np.minimum(start[:, 1], end[:, 1]), np.maximum(start[:, 1], end[:, 1])
    first = np.clip(np.floor((low - z_edges[0]) / height).astype(int), 0, len(z_edges) - 2)
    last = np.clip(np.ceil((high - z_edges[0]) / height).astype(int), first + 1, len(z_edges) - 1)
    counts = np.where(high > low, last - first, 0)
    edge = np.repeat(np.arange(len(start)), counts)
    row = np.repeat(first, counts) + np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)

    def share(z):
        return (np.clip(z, z_edges[row], z_edges[row + 1]) - start[edge, 1]) / (end[edge, 1] - start[edge, 1])

    s, t = share(start[edge, 1]), share(end[edge, 1])
    a = start[edge, 0] + s * (end[edge, 0] - start[edge, 0])
    b = start[edge, 0] + t * (end[edge, 0] - start[edge, 0])
    radius = 0.5 * (a + b) if planar else np.sqrt((a * a + a * b + b * b) / 3.0)
    return row, radius, weight[edge] * (t - s) * (end[edge, 1] - start[edge, 1]) / height


def areal_density(corners, density, x_edges, z_edges, planar=False):
    """Means over the pixels between equal x_edges and z_edges (cm), [rows, columns], of elements with these corners
    (n, 4, 2: r, z) and densities (g/cm^3). In g/cm^2; planar: g/cm^2 per cm of depth. Axisymmetric pictures show one half,
    x >= 0, a planar one what is right of its first edge."""
    x_edges, z_edges = np.asarray(x_edges, dtype=float), np.asarray(z_edges, dtype=float)
    image = np.zeros((len(z_edges) - 1, len(x_edges) - 1))
    row, radius, weight = pieces(corners, density, z_edges, planar)
    integral = strip_integral if planar else disc_integral
    for begin in range(0, len(row), EDGES_AT_A_TIME):
        part = slice(begin, begin + EDGES_AT_A_TIME)
        columns = np.diff(integral(radius[part, None], x_edges[None, :]), axis=1)
        np.add.at(image, row[part], weight[part, None] * columns)
    return np.maximum(image, 0.0) / np.diff(x_edges)  # round-off of what cancels may leave less than nothing


def image_of(run, snapshot, window):
    """Areal density in a window, [rows, columns], and its extent."""
    size = (window.z_max - window.z_min) / PIXELS
    columns = int(np.ceil((window.x_max - window.x_min) / size))
    x_edges, z_edges = window.x_min + size * np.arange(columns + 1), window.z_min + size * np.arange(PIXELS + 1)
    image = areal_density(snapshot.corners, snapshot.array("density"), x_edges, z_edges, run.is_planar)
    if not run.is_planar:
        image = np.hstack([image[:, ::-1], image])
    return image, (x_edges[0] if run.is_planar else -x_edges[-1], x_edges[-1], z_edges[0], z_edges[-1])


def densest(run, windows):
    """Where the scale of all radiographs of a run ends: at the beginnings of its stages plates are seen edge on."""
    most = 0.0
    for first in (group[0] for _, group in run.stages()):
        most = max(most, image_of(run, first, windows[first.number])[0].max())
        first.forget()
    return round_up(most)


def picture(run, snapshot, window, most, path):
    """A radiograph of one written time: dark is dense; over five powers of ten below MOST."""
    image, extent = image_of(run, snapshot, window)
    width = 6.0 * image.shape[1] / image.shape[0]
    figure, axes = plt.subplots(figsize=(width + 1.9, 6.9), layout="constrained")
    shown = axes.imshow(np.maximum(image, 1e-12), origin="lower", cmap="gray_r", norm=LogNorm(most * 10.0**-DECADES, most),
                        extent=extent, aspect="equal")
    label = "areal density, g/cm$^2$" + (" per cm of depth" if run.is_planar else "")
    figure.colorbar(shown, ax=axes, label=label, shrink=0.8).minorticks_off()
    scale_bar(axes, window)
    axes.set(xlabel="x, cm", ylabel="y, cm" if run.is_planar else "z, cm")
    axes.set_title(f"radiograph, {snapshot.stage}, t = {snapshot.time - run.contact_time:.3f} us after contact", fontsize=11)
    figure.savefig(path, dpi=130)
    plt.close(figure)
