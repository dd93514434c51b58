# SPDX-License-Identifier: LGPL-2.1-or-later
"""The output of one run."""
import glob
import os
from functools import cached_property

from . import scene
from .errors import Named, NotARun, NotWritten, Unknown
from .files import read_json, read_parameters, read_table
from .snapshot import by_stage, nearest, read_snapshots


def results_by_place(tables):
    """Tables of results that say what they hold when they are asked for something else."""
    return Named({place: Named(table, f"result of {place}") for place, table in tables.items()}, "place")


class Run:
    """A run in DIRECTORY, complete or not; files are read when they are asked for.

    All numbers are in cm, g, us, Mbar unless a unit is asked for. Errors: NotARun if this is no run; Damaged where a file is cut
    short; NotWritten where there is none."""

    def __init__(self, directory):
        self.directory = os.fspath(directory)
        if not os.path.isfile(self.path("parameters.prm")):
            raise NotARun(f"{self.directory}: is not the output of a run (no parameters.prm)")

    def __repr__(self):
        return f"<Run {self.directory}: {self.title}>"

    def path(self, *names):
        return os.path.join(self.directory, *names)

    @cached_property
    def parameters(self):
        """'Section/Key' -> text of every value in force; .differing() lists those that are not the defaults."""
        return read_parameters(self.path("parameters.prm"))

    @property
    def title(self):
        return self.parameters.get("Title") or os.path.basename(os.path.abspath(self.directory))

    @cached_property
    def is_planar(self):
        """Whether the scene has no axis about which it could be mirrored."""
        return scene.is_planar(self.parameters)

    @cached_property
    def plates(self):
        """Plates along the line of flight. Errors: Unknown."""
        return scene.plates(self.parameters)

    @property
    def bodies(self):
        """Name -> entries of each body."""
        return scene.bodies(self.parameters)

    @property
    def materials(self):
        return scene.materials(self.parameters)

    @cached_property
    def contact_time(self):
        """When the projectile touches the first plate, us."""
        return scene.contact_time(self.parameters)

    @cached_property
    def summary_or_none(self):
        """summary.json (doc/summary.md), or None of a run that has not ended."""
        return read_json(self.path("summary.json"), ("status", "stages", "results"))

    @property
    def summary(self):
        """summary.json (doc/summary.md). Errors: NotWritten if the run has not ended."""
        if self.summary_or_none is None:
            raise NotWritten(f"{self.directory}: has no summary.json: the run has not ended")
        return self.summary_or_none

    @property
    def status(self):
        """'completed', 'stopped', or 'not ended'."""
        return self.summary_or_none["status"] if self.summary_or_none else "not ended"

    @cached_property
    def results(self):
        """Place (plate, gap, wall) -> key -> number, true or false, list, or None (doc/results.md). Errors: NotWritten."""
        return results_by_place(self.summary["results"])

    @property
    def error_bars(self):
        """Place -> key -> estimate of the error, as results; empty where the scene asks for none."""
        return self.summary.get("error_bars") or {}

    @cached_property
    def statistics(self):
        """The table of statistics.csv: a row a written step. Errors: NotWritten."""
        table = read_table(self.path("statistics.csv"))
        if table is None:
            raise NotWritten(f"{self.directory}: has no statistics.csv (Output/Statistics interval of the scene)")
        return table

    @cached_property
    def history(self):
        """The table of history.csv: results against time; None of a run that has not written it."""
        return read_table(self.path("history.csv"))

    @cached_property
    def gauges(self):
        """Name -> table of what each gauge has seen."""
        paths = sorted(glob.glob(os.path.join(glob.escape(self.directory), "gauges", "*.csv")))
        return Named({os.path.basename(path)[:-4]: read_table(path) for path in paths}, "gauge")

    @cached_property
    def snapshots_or_none(self):
        """All written times; an empty list of a run without fields."""
        return read_snapshots(self.directory, self.materials)

    @property
    def snapshots(self):
        """All written times. Errors: NotWritten."""
        if not self.snapshots_or_none:
            raise NotWritten(f"{self.directory}: has no fields: set Output/Fields interval in the scene")
        return self.snapshots_or_none

    def snapshots_of(self, stage=None):
        """Written times of one stage, or all. Errors: Unknown, NotWritten."""
        chosen = [s for s in self.snapshots if stage in (None, s.stage)]
        if not chosen:
            raise Unknown(f"there is no stage '{stage}'; there is: {', '.join(name for name, _ in self.stages())}")
        return chosen

    @property
    def times(self):
        """Of all written fields, us; a hand-over is there twice."""
        return [snapshot.time for snapshot in self.snapshots]

    def stages(self):
        """[(stage, [its written times])] in the order of the run. Errors: NotWritten."""
        return by_stage(self.snapshots)

    def is_moving(self, stage):
        """Whether a stage computes on moving elements."""
        return self.parameters.get(f"Stages/{stage}/Mode") == "lagrangian"

    def elements(self, time=None, stage=None):
        """The elements at the written time nearest to TIME (us), of one stage if it is given; without a time at the end.
        Errors: Unknown, NotWritten."""
        chosen = self.snapshots_of(stage)
        return chosen[-1] if time is None else nearest(chosen, time)

    def field(self, name, time=None, stage=None, unit=None):
        """A field at the written time nearest to TIME (us): Field with .values, .unit, .elements. Errors: Unknown, NotWritten,
        Damaged."""
        return self.elements(time, stage).field(name, unit)

    @property
    def log(self):
        """Text of log.txt; '' if there is none."""
        if not os.path.exists(self.path("log.txt")):
            return ""
        with open(self.path("log.txt"), encoding="utf-8", errors="replace") as file:
            return file.read()
