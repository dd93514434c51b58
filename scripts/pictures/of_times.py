# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of written times: which, with which window and scale."""
import multiprocessing
import os

from whipple import Unknown

from . import frames, quantities, radiograph, windows
from .drawn import Job, state_of


class Times:
    """What all pictures of a run share: scales, windows.

    names: quantities of the right and of the left half. window: of all, or None for those that follow."""

    def __init__(self, run, names, window=None):
        self.run, self.names = run, names
        self.snapshots = run.snapshots
        with multiprocessing.get_context("fork").Pool(min(len(os.sched_getaffinity(0)), len(self.snapshots))) as pool:
            tasks = [(run, snapshot.number, [n for n in names if n != "bodies"]) for snapshot in self.snapshots]
            looked_at = pool.starmap(look_at, tasks, chunksize=max(len(tasks) // 8, 1))
        extents = [extent for extent, _ in looked_at]
        self.scales = quantities.scales_of([n for n in names if n != "bodies"], self.snapshots,
                                           lambda quantity: [ranges[quantity.name] for _, ranges in looked_at])
        self.windows = [window] * len(extents) if window else windows.windows_of(run, extents)
        self.scene = windows.whole_scene(run, extents)

    def made_of(self, *more):
        run = self.run
        return (*more, self.names, self.scales, self.scene, run.is_planar, state_of(run.path("summary.json")), state_of(run.path("history.csv")))

    def frame(self, snapshot, kind):
        """The job of one written time."""
        window = self.windows[snapshot.number]
        return Job(f"{stem(self.names)}-{snapshot.number:05d}.{kind}", frames.frame,
                   (self.run, snapshot, window, self.scene, self.names, self.scales),
                   self.made_of(state_of(snapshot.path), snapshot.stage, snapshot.time, window))


def look_at(run, number, names):
    """Extent of what matters at a written time, and the range of each quantity. What was read is forgotten with the process."""
    snapshot = run.snapshots[number]
    ranges = {name: quantities.extremes(quantities.quantity_of(name, snapshot), snapshot) for name in names}
    extent = windows.extent(snapshot, run.is_planar)
    snapshot.forget()
    return extent, ranges


def stem(names):
    """Of the files: those of the usual picture are fields-00000.png ..."""
    return "fields" if names == ("density", "bodies") else "-".join(dict.fromkeys(n.replace(" ", "_") for n in names if n != "bodies")) or "bodies"


def chosen(run, every=1, stage=None, time=None):
    """Written times that are asked for. Errors: whipple.Unknown, whipple.NotWritten."""
    if time is not None:
        return [run.elements(time, stage)]
    return run.snapshots_of(stage)[::every]


def radiographs(run, snapshots, window, kind):
    """Jobs of what flash radiographs would show."""
    where = [window] * len(run.snapshots) if window else windows.windows_of(run, [look_at(run, s.number, ())[0] for s in run.snapshots])
    most = radiograph.densest(run, where)
    return [Job(f"radiograph-{s.number:05d}.{kind}", radiograph.picture, (run, s, where[s.number], most),
                (state_of(s.path), s.time, where[s.number], most)) for s in snapshots]


def against(run, other, snapshots, names, window, kind):
    """Jobs of pictures of two runs side by side, at times of the first; one window and scale for both."""
    if run.is_planar != other.is_planar:
        raise Unknown("one run is planar, the other axisymmetric: they cannot be drawn side by side")
    both = [Times(run, names, window), Times(other, names, window)]
    scales = {name: quantities.Scale(scale.quantity, min(t.scales[name].low for t in both), max(t.scales[name].high for t in both))
              for name, scale in both[0].scales.items()}
    words = [os.path.basename(os.path.abspath(r.directory)) for r in (run, other)]
    pair = (names[0], names[0]) if run.is_planar else names
    jobs = []
    for snapshot in snapshots:
        matches = [s for s in other.snapshots if s.stage == snapshot.stage] or other.snapshots
        twin = min(reversed(matches), key=lambda s: abs(s.time - snapshot.time))
        shown = windows.of_both(both[0].windows[snapshot.number], both[1].windows[twin.number])
        jobs.append(Job(f"against-{stem(names)}-{snapshot.number:05d}.{kind}", frames.side_by_side,
                        ([(run, snapshot, words[0]), (other, twin, words[1])], shown, pair, scales),
                        (both[0].made_of(state_of(snapshot.path), shown), both[1].made_of(state_of(twin.path)))))
    return jobs
