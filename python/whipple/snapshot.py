# SPDX-License-Identifier: LGPL-2.1-or-later
"""The elements of a run as they stood at one written time, and the fields on them."""
import os
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass

import h5py
import numpy as np

from .errors import Damaged, Unknown
from .units import convert

VELOCITIES = {"axial velocity": 1, "radial velocity": 0}


@dataclass(frozen=True)
class Field:
    """Values of one field, one an element; numpy takes it as their array."""

    name: str
    values: np.ndarray
    unit: str
    elements: "Snapshot"

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self.values, dtype=dtype)

    def __len__(self):
        return len(self.values)

    def to(self, unit):
        """The same in another unit. Errors: units.Unknown."""
        return Field(self.name, convert(self.values, self.unit, unit), unit, self.elements)


def dataset_name(name):
    """Of a field 'aluminium void fraction' in the HDF5 files."""
    return re.sub(r"[^A-Za-z0-9]", "_", name)


class Snapshot:
    """One written time. Arrays are read when they are asked for, and kept until forget().

    number: its place among the written times; stage: name of the stage; time: us since the start."""

    def __init__(self, path, number, stage, time, material_names=()):
        self.path, self.number, self.stage, self.time = path, number, stage, time
        self.material_names = tuple(material_names)
        self.arrays, self.names_and_units = {}, None

    def __repr__(self):
        return f"<Snapshot {self.number}: stage {self.stage}, {self.time:g} us>"

    def open(self):
        try:
            return h5py.File(self.path, "r")
        except FileNotFoundError:
            raise Damaged(f"{self.path}: is named in fields.xdmf and not there") from None
        except OSError:
            raise Damaged(f"{self.path}: is cut short, or no HDF5 file") from None

    def array(self, name):
        """A dataset as it stands in the file. Errors: Damaged, Unknown."""
        if name not in self.arrays:
            with self.open() as file:
                if name not in file:
                    raise Unknown(f"{self.path}: has no '{name}'")
                try:
                    self.arrays[name] = file[name][:]
                except OSError:
                    raise Damaged(f"{self.path}: '{name}' cannot be read: the file is cut short") from None
        return self.arrays[name]

    def forget(self):
        """Give the memory back."""
        self.arrays = {}

    @property
    def datasets(self):
        """Names of the cell fields in the file -> their units."""
        if self.names_and_units is None:
            with self.open() as file:
                self.names_and_units = {name: str(data.attrs.get("unit", "")) for name, data in file.items() if data.ndim == 1}
        return self.names_and_units

    def __len__(self):
        return len(self.array("cells"))

    @property
    def corners(self):
        """[n, 4, 2]: corners of each element, counter-clockwise, cm."""
        return self.array("nodes")[self.array("cells")]

    @property
    def centres(self):
        """[n, 2]: mean of the corners, cm."""
        return self.corners.mean(axis=1)

    @property
    def velocity(self):
        """[n, 2]: mean over the corners, cm/us."""
        return self.array("velocity")[:, :2][self.array("cells")].mean(axis=1)

    def of_materials(self, name):
        """[(material, dataset)] of those materials that have a field of this name."""
        pairs = [(material, dataset_name(f"{material} {name}")) for material in self.material_names]
        return [(material, dataset) for material, dataset in pairs if dataset in self.datasets]

    def weight(self, material, by_volume):
        """Volume, or mass, of a material in each element, over the volume of the element."""
        volume = self.array(dataset_name(f"{material} volume fraction")).astype(float)
        return volume if by_volume else volume * self.array(dataset_name(f"{material} density"))

    def mean_over_materials(self, name, parts):
        """By volume for fractions of a volume, else by mass; nan where an element has none of these materials."""
        if len(parts) == 1:
            return self.array(parts[0][1])
        by_volume = name == "void fraction"
        weights = np.array([self.weight(material, by_volume) for material, _ in parts], dtype=float)
        values = np.array([self.array(dataset) for _, dataset in parts], dtype=float)
        total = weights.sum(axis=0)
        return np.divide((weights * np.nan_to_num(values)).sum(axis=0), total, out=np.full(total.shape, np.nan), where=total > 0)

    def field(self, name, unit=None):
        """A field by its name in fields.xdmf ('density', 'aluminium plastic strain'); without its material the mean over
        the materials; or 'speed', 'axial velocity', 'radial velocity'. Errors: Unknown, Damaged."""
        dataset = dataset_name(name)
        parts = self.of_materials(name)
        if name == "speed":
            values, own = np.hypot(*self.velocity.T), "cm/us"
        elif name in VELOCITIES:
            values, own = self.velocity[:, VELOCITIES[name]], "cm/us"
        elif dataset in self.datasets:
            values, own = self.array(dataset), self.datasets[dataset]
        elif parts:
            values, own = self.mean_over_materials(name, parts), self.datasets[parts[0][1]]
        else:
            raise Unknown(f"there is no field '{name}' at {self.time:g} us; there is: {', '.join(self.field_names())}")
        found = Field(name, values, own, self)
        return found.to(unit) if unit else found

    def field_names(self):
        """All that field() takes here, without the names of materials: any of one material can have its name before it."""
        prefixes = [dataset_name(material) + "_" for material in self.material_names]
        short = [next((dataset[len(prefix):] for prefix in prefixes if dataset.startswith(prefix)), dataset)
                 for dataset in self.datasets]
        return ["speed", *VELOCITIES, *sorted(set(name.replace("_", " ") for name in short))]

    def body_shares(self, bodies):
        """[n, bodies]: mass share of each body in each element. BODIES: name -> entries, as of a run. Written are the tags of all
        bodies but the last of each material; without tags bodies of one material have no share."""
        names = list(bodies)
        shares = np.zeros((len(self), len(names)))
        whole = np.zeros(len(self))
        for material in self.material_names:
            mass = self.weight(material, by_volume=False)
            whole += mass
            of_it = [name for name in names if bodies[name]["Material"] == material]
            tags = [dataset_name(f"{material} body {name}") for name in of_it[:-1]]
            if not of_it or any(tag not in self.datasets for tag in tags):
                continue
            rest = np.ones(len(self))
            for name, tag in zip(of_it, tags):
                share = np.clip(np.nan_to_num(self.array(tag)), 0.0, rest)
                shares[:, names.index(name)] += share * mass
                rest -= share
            shares[:, names.index(of_it[-1])] += rest * mass
        return np.divide(shares, whole[:, None], out=np.zeros_like(shares), where=whole[:, None] > 0)


def read_snapshots(directory, material_names):
    """All written times of DIR/fields.xdmf, in their order; none of a run without field files. Errors: Damaged."""
    path = os.path.join(directory, "fields.xdmf")
    if not os.path.exists(path):
        return []
    found = []
    try:
        for grid in ElementTree.parse(path).getroot().iter("Grid"):
            if grid.get("GridType", "Uniform") == "Uniform":
                file = grid.find("Topology/DataItem").text.split(":/")[0].strip()
                found.append(Snapshot(os.path.join(directory, file), len(found), grid.get("Name"),
                                      float(grid.find("Time").get("Value")), material_names))
    except (ElementTree.ParseError, AttributeError, TypeError, ValueError):
        raise Damaged(f"{path}: is cut short, or not what a run writes") from None
    return found


def nearest(snapshots, time):
    """The written time nearest to a time in us; of two the later, which is what a hand-over has made."""
    return min(reversed(snapshots), key=lambda snapshot: abs(snapshot.time - time))


def by_stage(snapshots):
    """[(stage, [snapshots])] in the order of the run."""
    groups = []
    for snapshot in snapshots:
        if not groups or groups[-1][0] != snapshot.stage:
            groups.append((snapshot.stage, []))
        groups[-1][1].append(snapshot)
    return groups
