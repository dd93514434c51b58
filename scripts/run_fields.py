# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields that a run has written, time by time. Needs python3-h5py."""
import os
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np


class Snapshot:
    """One written time: corners of the elements (counter-clockwise) and the fields on them, read when they are asked for."""

    def __init__(self, directory, grid, number):
        self.number = number
        self.stage = grid.get("Name")
        self.time = float(grid.find("Time").get("Value"))
        self.path = os.path.join(directory, grid.find("Topology/DataItem").text.split(":/")[0])
        self.loaded = None

    def load(self):
        if self.loaded is None:
            with h5py.File(self.path, "r") as file:
                cells = file["cells"][:]
                self.loaded = {
                    "corners": file["nodes"][:][cells],
                    "axial_velocity": file["velocity"][:, 1][cells].mean(axis=1),
                    "fields": {name: data[:] for name, data in file.items() if data.ndim == 1},
                }
        return self.loaded

    def forget(self):
        """Give the memory back."""
        self.loaded = None

    @property
    def corners(self):
        return self.load()["corners"]

    @property
    def axial_velocity(self):
        return self.load()["axial_velocity"]

    @property
    def fields(self):
        return self.load()["fields"]


def snapshots(directory):
    """All written times of DIR/fields.xdmf, in their order; none of a run without field files."""
    path = os.path.join(directory, "fields.xdmf")
    if not os.path.exists(path):
        return []
    grids = ElementTree.parse(path).getroot().findall("Domain/Grid/Grid")
    return [Snapshot(directory, grid, number) for number, grid in enumerate(grids)]


def nearest(times, time):
    """Of written times the one nearest to a time in us; of two the later, which is what a hand-over has made."""
    return min(reversed(times), key=lambda snapshot: abs(snapshot.time - time))


def stages(times):
    """Written times stage by stage: [(name, [snapshots])] in the order of the run."""
    groups = []
    for snapshot in times:
        if not groups or groups[-1][0] != snapshot.stage:
            groups.append((snapshot.stage, []))
        groups[-1][1].append(snapshot)
    return groups


def window_of(corners, margin=0.05):
    """r_max, z_min, z_max that hold all elements."""
    points = np.asarray(corners).reshape(-1, 2)
    z_min, z_max = points[:, 1].min(), points[:, 1].max()
    extra = margin * (z_max - z_min)
    return points[:, 0].max() + extra, z_min - extra, z_max + extra
