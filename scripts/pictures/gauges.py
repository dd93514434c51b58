# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of tables against time: each gauge, the history of results."""
import matplotlib.pyplot as plt
import numpy as np


def curves(title, time, columns, path):
    """One panel for each of {label: values}."""
    figure, axes = plt.subplots(len(columns), 1, sharex=True, squeeze=False, layout="constrained", figsize=(8, 1 + 1.8 * len(columns)))
    for axis, (label, values) in zip(axes[:, 0], columns.items()):
        axis.plot(time, values, linewidth=1, marker="." if len(time) < 50 else None)
        axis.set_ylabel(label)
        axis.grid(alpha=0.3)
    axes[-1, 0].set_xlabel("time, us")
    figure.suptitle(title)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def moves(values):
    return len(set(values[np.isfinite(values)])) > 1


def seen(table):
    """{label: values} of everything a gauge has seen; its position only if it moves."""
    return {title.replace(" [", "\n["): table[column] for column, title in table.headers.items()
            if column != "time" and (moves(table[column]) or not column.startswith("position"))}


def gauge(name, table, path):
    """Everything a gauge has seen against time."""
    curves(f"gauge {name}", table["time"], seen(table), path)


def pictures(run):
    """[(file name, what draws it, its arguments)] of all gauges."""
    return [(f"gauge-{name}", gauge, (name, table)) for name, table in run.gauges.items()]
