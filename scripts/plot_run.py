#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a run: for each written time density, solid fraction and axial velocity of the elements as they are
(deformed in Lagrangian stages), mirrored about the axis; and of each gauge its fields against time.

    scripts/plot_run.py DIR [--output FOLDER] [--every N] [--window R Z_MIN Z_MAX] [--planar]

Needs python3-matplotlib and python3-h5py.
"""
import argparse
import os
import xml.etree.ElementTree as ElementTree

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm, Normalize

from plot_gauges import draw_gauges


class Snapshot:
    """One written time: corners of the elements and the fields on them."""

    def __init__(self, directory, grid):
        self.stage = grid.get("Name")
        self.time = float(grid.find("Time").get("Value"))
        file_name = grid.find("Topology/DataItem").text.split(":/")[0]
        with h5py.File(os.path.join(directory, file_name), "r") as file:
            cells = file["cells"][:]
            self.corners = file["nodes"][:][cells]
            self.axial_velocity = file["velocity"][:, 1][cells].mean(axis=1)
            self.fields = {name: data[:] for name, data in file.items() if data.ndim == 1}


def read_run(directory):
    """All snapshots of DIR/fields.xdmf, one after the other."""
    path = os.path.join(directory, "fields.xdmf")
    if not os.path.exists(path):
        return  # a run without field files
    root = ElementTree.parse(path).getroot()
    for grid in root.findall("Domain/Grid/Grid"):
        yield Snapshot(directory, grid)


def draw(axes, corners, values, norm, colours):
    """Elements in one half of the picture; edges in their own colour so that no seams show."""
    shapes = PolyCollection(corners, array=values, norm=norm, cmap=colours, edgecolors="face", linewidths=0.2)
    axes.add_collection(shapes)
    return shapes


def window_of(snapshot, margin=0.05):
    """r_max, z_min, z_max that hold everything drawn."""
    points = snapshot.corners.reshape(-1, 2)
    z_min, z_max = points[:, 1].min(), points[:, 1].max()
    extra = margin * (z_max - z_min)
    return points[:, 0].max() + extra, z_min - extra, z_max + extra


def picture(snapshot, path, window, planar):
    """Density on the right, solid fraction on the left (mirrored); beside them the axial velocity."""
    r_max, z_min, z_max = window or window_of(snapshot)
    height = 7.0
    width = np.clip(height * 2 * r_max / (z_max - z_min), 3.0, 9.0)
    figure, (left, right) = plt.subplots(1, 2, figsize=(2 * width + 2.5, height), layout="constrained")
    mirrored = snapshot.corners * [-1.0, 1.0]
    density = np.maximum(snapshot.fields["density"], 1e-12)
    scale = LogNorm(1e-4 * density.max(), density.max())
    bar = draw(left, snapshot.corners, density, scale, "inferno")
    figure.colorbar(bar, ax=left, label="density, g/cm$^3$", shrink=0.8)
    if not planar:
        solid = np.maximum(snapshot.fields["solid_fraction"], 1e-12)
        bar = draw(left, mirrored, solid, LogNorm(1e-4, 1.0), "viridis")
        figure.colorbar(bar, ax=left, label="solid fraction (left half)", shrink=0.8, location="left")

    speed = 10.0 * snapshot.axial_velocity  # cm/us -> km/s
    scale = Normalize(min(speed.min(), 0.0), max(speed.max(), 0.0) or 1.0)
    for corners in (snapshot.corners,) if planar else (snapshot.corners, mirrored):
        bar = draw(right, corners, speed, scale, "coolwarm")
    figure.colorbar(bar, ax=right, label="axial velocity, km/s", shrink=0.8)
    for axes in (left, right):
        axes.set(xlim=(0 if planar else -r_max, r_max), ylim=(z_min, z_max), aspect="equal")
        axes.set(xlabel="x, cm" if planar else "r, cm", ylabel="y, cm" if planar else "z, cm")
    figure.suptitle(f"{snapshot.stage}, t = {snapshot.time:.3f} us, {len(snapshot.corners)} elements")
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--output", help="folder of the pictures; default DIR/pictures")
    parser.add_argument("--every", type=int, default=1, help="only each N-th written time")
    parser.add_argument("--window", type=float, nargs=3, metavar=("R", "Z_MIN", "Z_MAX"), help="part to show, cm")
    parser.add_argument("--planar", action="store_true", help="do not mirror")
    arguments = parser.parse_args()
    folder = arguments.output or os.path.join(arguments.directory, "pictures")
    os.makedirs(folder, exist_ok=True)
    for number, snapshot in enumerate(read_run(arguments.directory)):
        if number % arguments.every:
            continue
        path = os.path.join(folder, f"fields-{number:05d}.png")
        picture(snapshot, path, arguments.window, arguments.planar)
        print(path)
    draw_gauges(arguments.directory, folder)


if __name__ == "__main__":
    main()
