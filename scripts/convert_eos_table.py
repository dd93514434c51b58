#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convert a text table of an equation of state into the HDF5 layout that the equation of state 'tabulated' reads
(doc/theory/equation_of_state_tables.md). Two text formats are told apart by themselves:

    SESAME     the ASCII form of the Los Alamos library: records that start with a line of integers (flag, material, type,
               number of words), then 5 numbers of 15 columns a line
    ANEOS      NEW-SESAME-STD.TXT and its like: records that start with "RECORD TYPE = ...", then 5 numbers of 16 columns a
               line. The extended tables with entropies and phases have no pressures: they are not read.

Read are the records 201 (normal density) and 301 (total equation of state: g/cm^3, K, GPa, MJ/kg).

    scripts/convert_eos_table.py TEXT OUTPUT.h5 [--material 3720] [--temperature 298.15] [--density 2.7]

Energies are counted from the state at rest, in which bodies enter a scene: at --temperature, the density next to the normal
one at which the pressure rises through zero, or through 1 bar where it never falls below zero (a gas; a table with Maxwell's
construction, whose liquid ends in a plateau of the vapour's pressure: its end is made a row of the file, and so is the state
at rest just above it, and the temperature a column). Or --density. Densities <= 0 (SESAME starts with one) are left out.

Energies that do not rise along the temperature are counted on the last line: the program leaves those points out.

Needs python3-h5py.
"""
import argparse
import re
import sys

import h5py
import numpy

ANEOS_RECORD = re.compile(r"\s*(INDEX|RECORD)\s+(?:MATID|TYPE)\s*=\s*(\d+)\s+NWDS\s*=\s*(\d+)")
BAR = 1e-4  # GPa
EXPONENT_WITHOUT_LETTER = re.compile(r"(\d)([+-]\d{3})$")  # Fortran's 1.0000000-100


class TableError(Exception):
    """What is wrong with the input, in one line."""


def number(text):
    return float(EXPONENT_WITHOUT_LETTER.sub(r"\1E\2", text.strip().replace("D", "E")))


def words(lines, start, count, columns):
    """The `count` numbers, five a line of fields of `columns` characters, from lines[start] on."""
    values = []
    for index, line in enumerate(lines[start:], start + 1):
        fields = [line[k:k + columns] for k in range(0, 5 * columns, columns)][:count - len(values)]
        try:
            values += [number(field) for field in fields if field.strip()]
        except ValueError:
            raise TableError(f"line {index}: '{line.rstrip()}': must be numbers of {columns} columns") from None
        if len(values) >= count:
            return numpy.array(values)
    raise TableError(f"the file ends after {len(values)} of {count} numbers of a record")


def sesame_records(lines):
    """(material, type) -> numbers, of the records 201 and 301."""
    records, line = {}, 0
    while line < len(lines):
        head = lines[line]
        if not head.strip() or head.split()[0] == "2":  # end of file
            break
        try:
            material, kind, count = int(head[2:8]), int(head[8:14]), int(head[14:20])
        except ValueError:
            raise TableError(f"line {line + 1}: '{head.rstrip()}': must start a record") from None
        if kind in (201, 301):
            records[material, kind] = words(lines, line + 1, count, 15)
        # records from 101 to 199 are text, 80 characters a line
        line += 1 + (-(-count // 80) if kind < 200 else -(-count // 5))
    return records


def aneos_records(lines):
    """The same; the file holds one material."""
    records, material = {}, 0
    for line, head in enumerate(lines):
        match = ANEOS_RECORD.match(head)
        if not match:
            continue
        name, kind, count = match[1], int(match[2]), int(match[3])
        if name == "INDEX":
            material = kind
        elif kind in (201, 301):
            records[material, kind] = words(lines, line + 1, count, 16)
    return records


def read_records(path):
    with open(path, encoding="ascii", errors="replace") as file:
        lines = file.read().splitlines()
    if not lines:
        raise TableError("the file is empty")
    return aneos_records(lines) if ANEOS_RECORD.match(lines[0]) else sesame_records(lines)


def chosen_material(records, wanted):
    materials = sorted({material for material, _ in records})
    complete = [m for m in materials if (m, 201) in records and (m, 301) in records]
    if wanted is not None and wanted not in complete:
        raise TableError(f"--material {wanted}: must be one with records 201 and 301, {complete}")
    if wanted is None and len(complete) != 1:
        raise TableError(f"materials with records 201 and 301: {complete}; choose with --material")
    return wanted if wanted is not None else complete[0]


class Table:
    """Record 301 over (density, temperature), rows of a density."""

    def __init__(self, record):
        n, m = int(record[0]), int(record[1])
        blocks = (len(record) - 2 - n - m) // (n * m)
        if blocks < 2:
            raise TableError(f"record 301 has {len(record)} words: must hold pressures and energies of {n} densities and "
                             f"{m} temperatures, {2 + n + m + 2 * n * m} words")
        self.density, self.temperature = record[2:2 + n], record[2 + n:2 + n + m]
        grids = record[2 + n + m:2 + n + m + blocks * n * m].reshape(blocks, m, n)  # densities run fastest
        there = self.density > 0
        self.density = self.density[there]
        self.pressure, self.energy = grids[0].T[there], grids[1].T[there]

    def isotherm(self, grid, temperature):
        """Column of a grid at a temperature, linear between the table's."""
        if not self.temperature[0] <= temperature <= self.temperature[-1]:
            raise TableError(f"--temperature {temperature}: must be in {self.temperature[0]:g} ... "
                             f"{self.temperature[-1]:g} K")
        return numpy.array([numpy.interp(temperature, self.temperature, row) for row in grid])

    def at_rest(self, normal_density, temperature):
        """The density nearest to the normal one at which the pressure rises through zero, else through 1 bar; the normal
        one if there is none. If the pressure comes out of a plateau there, rows are added."""
        pressure = self.isotherm(self.pressure, temperature)
        for level in (0., BAR):
            crossed = numpy.nonzero((pressure[:-1] <= level) & (pressure[1:] > level))[0]
            if len(crossed) == 0:
                continue
            ends = [self.ends_a_plateau(pressure, i) for i in crossed]
            values = [(lambda x, i=i, end=end: (branch if end else cubic)(self.density, pressure, i, x))
                      for i, end in zip(crossed, ends)]
            roots = [bisect(value, level, *self.density[i:i + 2]) for value, i in zip(values, crossed)]
            best = min(range(len(roots)), key=lambda k: abs(roots[k] - normal_density))
            if ends[best]:
                i, rest = crossed[best], roots[best]
                edge = rest - BAR * (rest - self.density[i + 1]) / (values[best](rest) - pressure[i + 1])
                self.add_column(temperature)
                self.add_rows(i, [density for density in (edge, rest) if density > self.density[i] * (1 + 1e-9)])
            return roots[best]
        return normal_density

    def ends_a_plateau(self, pressure, i):
        """Whether the pressure hardly rises below the interval i and steeply above it."""
        if not 0 < i < len(pressure) - 3:
            return False
        below, above = (numpy.diff(pressure[k:k + 2])[0] / numpy.diff(self.density[k:k + 2])[0] for k in (i - 1, i + 1))
        return abs(below) < 0.1 * above

    def add_column(self, temperature):
        """The isotherm itself: within a column of the plateau's end the pressure has a kink."""
        j = int(numpy.searchsorted(self.temperature, temperature))
        if min(abs(self.temperature - temperature)) > 1e-6 * temperature:
            self.pressure, self.energy = (numpy.insert(grid, j, self.isotherm(grid, temperature), axis=1)
                                          for grid in (self.pressure, self.energy))
            self.temperature = numpy.insert(self.temperature, j, temperature)

    def add_rows(self, i, densities):
        """Rows in the interval i, each column interpolated from the side of the larger densities."""
        columns = len(self.temperature)
        pressure = [[branch(self.density, self.pressure[:, j], i, x) for j in range(columns)] for x in densities]
        energy = [[branch(self.density, self.pressure[:, j], i, x, self.energy[:, j]) for j in range(columns)]
                  for x in densities]
        if densities:
            self.pressure = numpy.insert(self.pressure, i + 1, pressure, axis=0)
            self.energy = numpy.insert(self.energy, i + 1, energy, axis=0)
            self.density = numpy.insert(self.density, i + 1, densities)

    def not_rising(self):
        """How many energies are not above all before them in their row; how far the lowest of them is below, and
        where."""
        highest = numpy.maximum.accumulate(self.energy, axis=1)
        fall = highest - self.energy
        i, j = numpy.unravel_index(numpy.argmax(fall), fall.shape)
        count = int(numpy.sum(self.energy[:, 1:] <= highest[:, :-1]))
        return count, fall[i, j], self.density[i], self.temperature[j]

    def energy_at(self, density, temperature):
        i = min(max(numpy.searchsorted(self.density, density, side="right") - 1, 0), len(self.density) - 2)
        return cubic(self.density, self.isotherm(self.energy, temperature), i, density)


def cubic(x, y, i, where):
    """The polynomial through the four points about the interval i."""
    begin = min(max(i - 1, 0), max(len(x) - 4, 0))
    points = range(begin, min(begin + 4, len(x)))
    return sum(y[j] * numpy.prod([(where - x[k]) / (x[j] - x[k]) for k in points if k != j]) for j in points)


def branch(x, pressure, i, where, y=None):
    """y (or the pressure) in the interval i without what lies below it: the polynomial through the points from i on, or from
    i + 1 on if that meets the plateau of the pressure within the interval."""
    y = pressure if y is None else y

    def polynomial(values, points, at):
        return sum(values[j] * numpy.prod([(at - x[k]) / (x[j] - x[k]) for k in points if k != j]) for j in points)
    if polynomial(pressure, range(i + 1, i + 4), x[i]) >= pressure[i]:
        return polynomial(y, range(i, i + 4), where)
    value = polynomial(y, range(i + 1, i + 4), where) if y is pressure else numpy.interp(where, x[i:i + 2], y[i:i + 2])
    return min(max(value, min(y[i:i + 2])), max(y[i:i + 2]))


def bisect(function, level, low, high):
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if function(middle) > level else (middle, high)
    return high


def write(path, table, density, energy, source):
    with h5py.File(path, "w") as file:
        file.attrs["reference_density"] = density
        file.attrs["reference_energy"] = energy
        file.attrs["source"] = source
        for name, values, units in (("density", table.density, "g/cm^3"), ("temperature", table.temperature, "K"),
                                    ("pressure", table.pressure, "GPa"), ("energy", table.energy, "MJ/kg")):
            file.create_dataset(name, data=values).attrs["units"] = units


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("text", help="table to read")
    parser.add_argument("output", help="HDF5 file to write")
    parser.add_argument("--material", type=int, help="number of the material, if the text has several")
    parser.add_argument("--temperature", type=float, default=298.15, help="of the state at rest, K")
    parser.add_argument("--density", type=float, help="of the state at rest, g/cm^3")
    arguments = parser.parse_args()
    try:
        records = read_records(arguments.text)
        material = chosen_material(records, arguments.material)
        table = Table(records[material, 301])
        normal = records[material, 201][2]
        density = arguments.density or table.at_rest(normal, arguments.temperature)
        if not table.density[0] <= density <= table.density[-1]:
            raise TableError(f"--density {density}: must be in {table.density[0]:g} ... {table.density[-1]:g} g/cm^3")
        energy = table.energy_at(density, arguments.temperature)
    except (OSError, TableError) as error:
        sys.exit(f"{arguments.text}: {error.strerror if isinstance(error, OSError) else error}")
    write(arguments.output, table, density, energy, f"{arguments.text}, material {material}")
    print(f"{arguments.output}: {len(table.density)} densities, {len(table.temperature)} temperatures; at rest "
          f"{density:.6g} g/cm^3, {arguments.temperature:g} K, energy {energy:.6g} MJ/kg of the text counts as zero")
    count, fall, at_density, at_temperature = table.not_rising()
    if count > 0:
        print(f"{arguments.output}: {count} of {table.energy.size} energies do not rise along the temperature and are left out "
              f"by the program; the deepest lies {fall:.3g} MJ/kg too low, at {at_density:.6g} g/cm^3, {at_temperature:.6g} K")


if __name__ == "__main__":
    main()
