# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results against time, from history.csv: a picture for each plate, gap and wall; nothing of a run without that file."""
import numpy as np

from whipple.units import readable

from .gauges import curves, moves


def tables(run):
    """Place -> {label: (times, values)} of results that change."""
    if run.history is None or "time_us" not in run.history:
        return {}
    found = {}
    for name in run.history:
        place, _, key = name.rpartition(" ")
        values = run.history[name]
        if place and values.dtype.kind == "f" and moves(values):
            words, unit = readable(key)
            found.setdefault(place, {})[f"{words},\n{unit}" if unit else words] = values
    return found


def of_place(place, time, columns, path):
    seen = np.isfinite(np.array(list(columns.values()))).any(axis=0)
    curves(f"{place}: results against time", time[seen], {label: values[seen] for label, values in columns.items()}, path)


def pictures(run):
    """[(file name, what draws it, its arguments)]."""
    return [(f"history-{place}", of_place, (place, run.history["time_us"], columns)) for place, columns in tables(run).items()]
