#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a run. Without options: for each written time density, solid fraction and axial velocity of the elements as
they are (deformed in Lagrangian stages), mirrored about the axis; and of each gauge its fields against time. Or one of:

    --radiograph [--time T]  what a flash radiograph would show at a time (us), or at each written one
    --strip                  all stages side by side, what is solid drawn solid
    --figure NAME            figures of the paper of 1993: all | handovers | 2a ... 4 (doc/output.md)
    --debris                 debris of each gap by angle and velocity, load on the last plate by radius
    --limit                  ballistic limit curve of the shield, with this shot and the tests near it

    scripts/plot_run.py DIR [--output FOLDER] [--every N] [--window R Z_MIN Z_MAX] [--planar] [one of the above]

Needs python3-matplotlib and python3-h5py.
"""
import argparse
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm, Normalize

import ballistic_limit
import figures
import plot_results
import radiograph
import run_fields
import run_record
from drawing import draw
from plot_gauges import draw_gauges


def picture(snapshot, path, window, planar):
    """Density on the right, solid fraction on the left (mirrored); beside them the axial velocity."""
    r_max, z_min, z_max = window or run_fields.window_of(snapshot.corners)
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


def each_time(times, arguments):
    for snapshot in times[::arguments.every]:
        path = os.path.join(arguments.output, f"fields-{snapshot.number:05d}.png")
        picture(snapshot, path, arguments.window, arguments.planar)
        snapshot.forget()
        yield path
    yield from draw_gauges(arguments.directory, arguments.output)


def radiographs(times, plates, arguments):
    chosen = times[::arguments.every] if arguments.time is None else [run_fields.nearest(times, arguments.time)]
    for snapshot in chosen:
        path = os.path.join(arguments.output, f"radiograph-{snapshot.number:05d}.png")
        radiograph.picture(snapshot, path, arguments.window, plates, arguments.planar)
        snapshot.forget()
        yield path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--output", help="folder of the pictures; default DIR/pictures")
    parser.add_argument("--every", type=int, default=1, help="only each N-th written time")
    parser.add_argument("--window", type=float, nargs=3, metavar=("R", "Z_MIN", "Z_MAX"), help="part to show, cm")
    parser.add_argument("--planar", action="store_true", help="do not mirror; default: as parameters.prm says")
    parser.add_argument("--time", type=float, metavar="T", help="the written time nearest to this one, us")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--radiograph", action="store_true", help="areal density seen from the side")
    what.add_argument("--strip", action="store_true", help="all stages side by side")
    what.add_argument("--figure", metavar="NAME", help="all | handovers | the name of one: 2a, 3f, 4 ...")
    what.add_argument("--debris", action="store_true", help="debris by angle and velocity, load by radius")
    what.add_argument("--limit", action="store_true", help="ballistic limit curve with this shot and tests")
    arguments = parser.parse_args()
    arguments.output = arguments.output or os.path.join(arguments.directory, "pictures")
    values = run_record.parameters(arguments.directory)
    arguments.planar = arguments.planar or run_record.is_planar(values)
    times = run_fields.snapshots(arguments.directory)
    os.makedirs(arguments.output, exist_ok=True)
    try:
        if not times and not (arguments.limit or arguments.debris or os.path.isdir(os.path.join(arguments.directory, "gauges"))):
            raise run_record.Unknown("has no fields (Output/Fields interval of the scene)")
        if arguments.radiograph:
            paths = radiographs(times, run_record.plates(values), arguments)
        elif arguments.strip:
            paths = figures.strip(times, values, arguments.output, arguments.planar)
        elif arguments.figure:
            paths = figures.by_name(arguments.figure, times, values, arguments.output, arguments.planar)
        elif arguments.debris:
            paths = plot_results.pictures(run_record.summary(arguments.directory), arguments.output)
        elif arguments.limit:
            paths = ballistic_limit.picture(values, run_record.summary(arguments.directory), arguments.output)
        else:
            paths = each_time(times, arguments)
        for path in paths:
            print(path)
    except run_record.Unknown as error:
        print(f"{arguments.directory}: {error}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
