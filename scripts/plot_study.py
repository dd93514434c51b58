#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plots of a study, from its study.json, as PNG and SVG:

    work_precision   error against wall time, a curve for every method: which setting to use at which accuracy
    convergence      error against cell size, with slopes of order 1 and 2
    cost             wall time, active cell-steps and memory against cell size

    scripts/plot_study.py DIR [--output FOLDER]

Needs python3-matplotlib.
"""
import math
import os
import re
import sys
import textwrap

from one_line import OneLine
import pictures  # noqa: F401  draws without a screen; finds whipple
import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter

import whipple

MARKERS = "osD^vPX<>p"
MOST_PANELS = 6


class Method:
    """Points that differ in their cells only: one curve."""

    def __init__(self, label, points, colour, marker):
        self.label = label
        self.points = points
        self.style = {"color": colour, "marker": marker, "label": label, "markersize": 6, "linewidth": 1.6}

    def curve(self, x, headline):
        """x, largest error and its part that is uncertain, and the points that have an error > 0."""
        rows = []
        for point in self.points:
            error = point["headline_errors"][headline]
            if error and error["error"] is not None and x(point):
                largest = error["error"] + error["uncertainty"]
                if largest > 0:
                    rows.append((x(point), largest, error["uncertainty"], point))
        return [list(column) for column in zip(*rows)] if rows else [[], [], [], []]


def methods_of(study):
    """One for each series, in the order of the study; those with one point last."""
    points = {point["label"]: point for point in study["points"]}
    series = sorted(study["series"], key=lambda s: len(s["points"]) < 2)
    colours = plt.get_cmap("tab10").colors if len(series) <= 10 else plt.get_cmap("tab20").colors
    return [
        Method(s["label"], [points[label] for label in s["points"]],
               colours[i % len(colours)], MARKERS[i % len(MARKERS)])
        for i, s in enumerate(series)
    ]


def error_label(study, headline):
    """What the axis of a headline's error says."""
    quantity = study["headlines"][headline]
    relative = any(e and e["relative"] for e in (p["headline_errors"][headline] for p in study["points"]))
    words, unit = quantity["readable"].split(",")[0], re.sub(r"\^(\d)", r"$^\1$", quantity["unit"])
    if quantity["exact"]:
        return f"{words}, {unit}" if unit else words
    return f"relative error of {words}" if relative else f"error of {words}, {unit}"


def plain_number(value, _):
    """0.01 rather than 10^-2, where it is as short."""
    if 1e-3 <= value < 1e4:
        return f"{value:g}"
    power = math.floor(math.log10(value) + 1e-9)
    digit = round(value / 10**power)
    return (f"${digit}\\cdot" if digit > 1 else "$") + f"10^{{{power}}}$"


def logarithmic(axes, cells=None):
    """Both axes logarithmic, with labels enough to read values off; ticks of a cell axis are the cells there are."""
    axes.set(xscale="log", yscale="log")
    axes.margins(x=0.16, y=0.08)
    axes.autoscale_view()
    for axis in (axes.xaxis, axes.yaxis):
        low, high = axis.get_view_interval()
        span = max(high, low) / min(high, low)
        marks = (1.0, 2.0, 5.0) if span < 50 else (1.0, 3.0) if span < 1000 else (1.0,)
        axis.set_major_locator(LogLocator(subs=marks, numticks=12))
        axis.set_major_formatter(FuncFormatter(plain_number))
        axis.set_minor_formatter(NullFormatter())
    if cells and len(cells) <= 8:
        axes.xaxis.set_major_locator(FixedLocator(cells))
        axes.xaxis.set_minor_locator(FixedLocator([]))
        axes.tick_params(axis="x", labelsize=8)
    axes.grid(True, which="major", color="0.85")
    axes.set_axisbelow(True)


def panels(count):
    """A figure with this many axes, up to three in a row."""
    columns = 2 if count == 4 else min(count, 3)
    rows = -(-count // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(5.6 * columns + 0.4, 4.2 * rows + 0.9), squeeze=False,
                                layout="constrained")
    flat = list(axes.flat)
    for unused in flat[count:]:
        unused.set_axis_off()
    return figure, flat[:count]


def legend(figure, axes):
    """One legend for all panels, in a strip of its own below them."""
    entries = {}
    for one in axes:
        for handle, label in zip(*one.get_legend_handles_labels()):
            entries.setdefault(label, handle)
    if not entries:
        return
    longest = max(len(label) for label in entries)
    columns = max(1, min(len(entries), int(figure.get_figwidth() * 11 / (longest + 8))))
    rows = -(-len(entries) // columns)
    strip = (0.23 * rows + 0.1) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, strip, 1, 1 - strip))
    figure.legend(entries.values(), entries.keys(), loc="lower center", ncol=columns, frameon=False)


def draw_errors(axes, methods, headline, x):
    """Curves of all methods: the largest error that a point may have; a bar reaches down to its distance from the
    reference, as far as that can be shown on a logarithmic axis."""
    drawn = False
    for method in methods:
        values, errors, uncertainties, _ = method.curve(x, headline)
        if not values:
            continue
        drawn = True
        if any(uncertainties):
            bars = [min(uncertainty, 0.7 * error) for error, uncertainty in zip(errors, uncertainties)]
            axes.errorbar(values, errors, yerr=[bars, [0.0] * len(bars)], capsize=3, **method.style)
        else:
            axes.plot(values, errors, **method.style)
    return drawn


def annotate_cells(axes, methods, headline):
    """Write the cell size beside the first and last point of each curve of the work-precision diagram, and beside points
    that the study gives a name of their own ("0.004 cm (1993)")."""
    for number, method in enumerate(methods):
        values, errors, _, points = method.curve(lambda p: p["wall_s"], headline)
        for i, point in enumerate(points if len(points) > 1 else []):
            if i in (0, len(points) - 1) or "(" in point["cell_label"]:
                axes.annotate(point["cell_label"], (values[i], errors[i]), textcoords="offset points",
                              xytext=(5, -11 if number % 2 else 5), fontsize=7.5, color=method.style["color"])


def reference_slopes(axes, methods, headline):
    """Lines of order 1 and 2 through the coarsest and worst point."""
    points = []
    for method in methods:
        cells, errors, _, _ = method.curve(lambda p: p["cell_cm"], headline)
        points += zip(cells, errors)
    if not points:
        return
    coarse, fine = max(h for h, _ in points), min(h for h, _ in points)
    top = max(e for h, e in points if h == coarse)
    if coarse == fine:
        return
    for order, dashes in ((1, (6, 3)), (2, (2, 2))):
        axes.plot([coarse, fine], [1.4 * top, 1.4 * top * (fine / coarse) ** order], color="0.45", dashes=dashes,
                  linewidth=1.1, label=f"order {order}")


def error_figure(study, methods, x, x_label, title, decorate, cells=None):
    count = len(study["headlines"])
    figure, all_axes = panels(count)
    for headline, axes in enumerate(all_axes):
        if draw_errors(axes, methods, headline, x):
            decorate(axes, methods, headline)
            logarithmic(axes, cells)
        else:
            axes.text(0.5, 0.5, "no point has a value", ha="center", transform=axes.transAxes)
        axes.set(xlabel=x_label, ylabel=textwrap.fill(error_label(study, headline), 34))
    figure.suptitle(title)
    legend(figure, all_axes)
    return figure


def cost_figure(study, methods):
    figure, all_axes = panels(3)
    quantities = (("wall time, s", lambda p: p["wall_s"]), ("active cell-steps", lambda p: p["active_cell_steps"]),
                  ("peak memory, MB", lambda p: p["peak_rss_bytes"] / 2**20))
    for axes, (label, value) in zip(all_axes, quantities):
        for method in methods:
            rows = [(p["cell_cm"], value(p)) for p in method.points if value(p) > 0]
            if rows:
                axes.plot(*zip(*rows), **method.style)
        logarithmic(axes, cells_of(study))
        axes.invert_xaxis()
        axes.set(xlabel="finest cell, cm (finer to the right)", ylabel=label)
    figure.suptitle(f"{study['title'] or study['study']}: cost")
    legend(figure, all_axes)
    return figure


def cells_of(study):
    return sorted({point["cell_cm"] for point in study["points"]})


def save(figure, folder, name):
    paths = [os.path.join(folder, f"{name}.{kind}") for kind in ("png", "svg")]
    for path in paths:
        figure.savefig(path, dpi=80)
    plt.close(figure)
    return paths


def draw(study, folder):
    """All plots of a study (whipple.Study); yields their paths."""
    content = study.content
    os.makedirs(folder, exist_ok=True)
    plt.rcParams.update({"svg.hashsalt": "whipple", "font.size": 10})  # the same file from the same study
    shown = {**content, "headlines": content["headlines"][:MOST_PANELS]}
    cell_axis = next((axis["name"] for axis in content["axes"] if axis["is_cell_axis"]), None)
    for point in content["points"]:
        point["cell_label"] = point["choices"].get(cell_axis, f"{point['cell_cm']:g} cm")
    methods = methods_of(shown)
    if methods and shown["headlines"]:
        yield from save(error_figure(shown, methods, lambda p: p["wall_s"], "wall time, s", f"{study.title}: error against price",
                                     annotate_cells), folder, "work_precision")
        yield from save(error_figure(shown, methods, lambda p: p["cell_cm"], "finest cell, cm",
                                     f"{study.title}: error against cell size", reference_slopes, cells_of(shown)), folder, "convergence")
    if methods:
        yield from save(cost_figure(shown, methods), folder, "cost")


def main():
    parser = OneLine("plot", __doc__)
    parser.add_argument("directory", help="directory of a study")
    parser.add_argument("--output", help="folder of the plots; default DIR")
    arguments = parser.parse_args()
    try:
        for path in draw(whipple.Study(arguments.directory), arguments.output or arguments.directory):
            print(path)
    except (whipple.WhippleError, OSError) as error:
        print(error, file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
