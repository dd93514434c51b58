# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the gauges of a run: one a gauge, each field against time; plot_run.py calls this."""
import csv
import glob
import math
import os

import matplotlib.pyplot as plt


def read_table(path):
    """Columns of a table by name, units included."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}


def draw_gauge(path, picture):
    """Everything a gauge has seen against time; its position only if it moves."""
    table = read_table(path)
    time = table.pop("time [us]")
    moves = {name: len(set(v for v in values if not math.isnan(v))) > 1 for name, values in table.items()}
    names = [name for name in table if moves[name] or not name.startswith("position")]
    figure, axes = plt.subplots(len(names), 1, sharex=True, squeeze=False, layout="constrained", figsize=(8, 1 + 2 * len(names)))
    for axis, name in zip(axes[:, 0], names):
        axis.plot(time, table[name], linewidth=1, marker="." if len(time) < 50 else None)
        axis.set_ylabel(name.replace(" [", "\n["))
        axis.grid(alpha=0.3)
    axes[-1, 0].set_xlabel("time [us]")
    figure.suptitle(f"gauge {os.path.basename(path)[:-4]}")
    figure.savefig(picture, dpi=110)
    plt.close(figure)


def draw_gauges(directory, folder):
    """A picture of each gauge of a run, if it has any; yields their paths."""
    for path in sorted(glob.glob(os.path.join(glob.escape(directory), "gauges", "*.csv"))):
        picture = os.path.join(folder, "gauge-" + os.path.basename(path)[:-4] + ".png")
        draw_gauge(path, picture)
        yield picture
