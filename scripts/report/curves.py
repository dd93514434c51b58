# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves against time: what a run has kept in statistics.csv, results in history.csv, gauges."""
import matplotlib.pyplot as plt
import numpy as np

from pictures import history
from pictures.gauges import seen

from .page import drawn, escape

MOST = 1500  # points of a curve
PANELS = (
    ("energy, Mbar cm³", ("kinetic energy", "internal energy")),
    ("dissipated, Mbar cm³", ("viscous work", "plastic work", "remap loss", "hourglass work")),
    ("axial momentum, g cm/us", ("axial momentum",)),
    ("mass, g", ("mass", "mass left domain")),
    ("time step, us", ("time step",)),
    ("active cells", ("active cells",)),
)


def thinned(table):
    """Rows to draw: of long tables every so many."""
    return np.unique(np.linspace(0, table.rows - 1, min(table.rows, MOST)).astype(int)) if table.rows else np.empty(0, dtype=int)


def grid(count, height=2.3):
    figure, axes = plt.subplots(-(-count // 2), 2, figsize=(11.5, height * -(-count // 2) + 0.3), squeeze=False, layout="constrained")
    for unused in list(axes.flat)[count:]:
        unused.set_axis_off()
    for one in axes.flat:
        one.grid(alpha=0.3)
        one.tick_params(labelsize=8)
        one.ticklabel_format(useOffset=False)
    return figure, list(axes.flat)[:count]


def statistics(run):
    """Energies, momentum, mass, time step, cells. Errors: whipple.NotWritten."""
    table = run.statistics
    rows = thinned(table)
    known = [(label, [name for name in names if name in table]) for label, names in PANELS]
    known = [(label, names) for label, names in known if names]
    if not len(rows) or not known:
        return ""
    figure, axes = grid(len(known))
    for one, (label, names) in zip(axes, known):
        for name in names:
            one.plot(table["time"][rows], table[name][rows], linewidth=1.1, label=name)
        if len(names) > 1:
            one.legend(fontsize=7.5)
        if label.startswith("time step"):
            one.set_yscale("log")
        one.set_ylabel(label, fontsize=9)
        one.set_xlabel("time, us", fontsize=9)
    return drawn(figure, "statistics.csv: energies, momentum, mass, time step and cells against time")


def against_time(title, words, time, columns, **how):
    """A figure of {label: values} with its title."""
    figure, axes = grid(len(columns), 1.9)
    for one, (label, values) in zip(axes, columns.items()):
        one.plot(time, values, **how)
        one.set_ylabel(label, fontsize=8)
        one.set_xlabel("time, us", fontsize=8)
    return f"<h3>{escape(title)}</h3>\n" + drawn(figure, words)


def results(run):
    """history.csv, a figure a place; nothing without the file."""
    return "".join(against_time(place, f"{place}: results against time", run.history["time_us"], columns, linewidth=1.2,
                                marker="." if run.history.rows < 40 else None)
                   for place, columns in history.tables(run).items())


def gauges(run):
    text = ""
    for name, table in run.gauges.items():
        rows, columns = thinned(table), seen(table)
        if columns and len(rows):
            text += against_time(f"gauge {name}", f"gauge {name}: what it has seen against time", table["time"][rows],
                                 {label: values[rows] for label, values in columns.items()}, linewidth=1.1)
    return text
