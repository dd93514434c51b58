# SPDX-License-Identifier: LGPL-2.1-or-later
"""The output of a study (doc/studies.md)."""
import os
from functools import cached_property

import numpy as np

from .errors import Named, NotARun, NotWritten
from .files import read_json
from .run import Run, results_by_place


class Point:
    """One run of a study: all of its entry in study.json by key, and its output as .run."""

    def __init__(self, entry, directory):
        self.entry, self.directory = entry, directory

    def __getitem__(self, key):
        return self.entry[key]

    def __repr__(self):
        return f"<Point {self.label}: {self.status}>"

    @property
    def label(self):
        return self.entry["label"]

    @property
    def status(self):
        return self.entry["status"]

    @property
    def choices(self):
        """Axis -> label of the value."""
        return self.entry["choices"]

    @property
    def cell_cm(self):
        return self.entry["cell_cm"]

    @property
    def results(self):
        """Place -> key -> value, numbers only."""
        return results_by_place(self.entry["results"])

    @cached_property
    def run(self):
        """What this run has left. Errors: NotARun."""
        return Run(self.directory)


class Study:
    """A study in DIRECTORY. Errors: NotARun, Damaged."""

    def __init__(self, directory):
        self.directory = os.fspath(directory)
        content = read_json(os.path.join(self.directory, "study.json"), ("study", "axes", "points", "series", "headlines"))
        if content is None:
            raise NotARun(f"{self.directory}: is not the output of a study (no study.json)")
        self.content = content

    def __repr__(self):
        return f"<Study {self.directory}: {len(self.points)} points>"

    @property
    def title(self):
        return self.content.get("title") or self.content["study"]

    @property
    def axes(self):
        """Name -> entry of study.json: labels, base, is_cell_axis, parameters."""
        return Named({axis["name"]: axis for axis in self.content["axes"]}, "axis")

    @cached_property
    def points(self):
        """Label -> point, in the order of the study."""
        return Named({entry["label"]: Point(entry, self.directory_of(entry["label"])) for entry in self.content["points"]},
                     "point")

    def directory_of(self, label):
        """Where a point has run."""
        return os.path.join(self.directory, "points", label)

    @property
    def runs(self):
        """Label -> run, of all points that left one."""
        found = {}
        for label, point in self.points.items():
            try:
                found[label] = point.run
            except NotARun:
                pass
        return Named(found, "run")

    def series(self, place, key):
        """Label of each series -> (cell sizes, values), coarse to fine, of one result. Errors: NotWritten if no point has it."""
        found = {}
        for series in self.content["series"]:
            rows = sorted(((self.points[label].cell_cm, self.points[label]["results"].get(place, {}).get(key))
                           for label in series["points"]), key=lambda row: -row[0])
            rows = [row for row in rows if row[1] is not None]
            if rows:
                found[series["label"]] = tuple(np.array(column, dtype=float) for column in zip(*rows))
        if not found:
            raise NotWritten(f"{self.directory}: no point has '{key}' of '{place}'")
        return Named(found, "series")

    def estimates(self, place, key):
        """Label of each series -> its estimate of one result: verdict, order, extrapolated, error_bar (doc/studies.md)."""
        found = {}
        for series in self.content["series"]:
            for result in series["results"]:
                if (result["quantity"]["place"], result["quantity"]["name"]) == (place, key):
                    found[series["label"]] = result["estimate"]
        return Named(found, "series")

    def to_pandas(self):
        """A row a point: choices, cost, and each result under 'place key'. Needs python3-pandas."""
        import pandas

        rows = []
        for point in self.points.values():
            row = {**point.choices, "status": point.status, "cell_cm": point.cell_cm, "wall_s": point["wall_s"]}
            for place, table in point.results.items():
                row.update({f"{place} {key}": value for key, value in table.items()})
            rows.append(row)
        return pandas.DataFrame(rows, index=list(self.points))
