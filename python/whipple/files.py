# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text files of a run: JSON, parameters, tables of comma-separated values."""
import csv
import json
import os
from collections.abc import Mapping

import numpy as np

from .errors import Damaged, Unknown


def read_json(path, keys):
    """The object in a JSON file; these KEYS must be in it. None if there is no file. Errors: Damaged."""
    try:
        with open(path, encoding="utf-8") as file:
            content = json.load(file)
    except FileNotFoundError:
        return None
    except (ValueError, OSError) as error:
        raise Damaged(f"{path}: cannot be read: {error}") from None
    missing = [key for key in keys if not isinstance(content, dict) or key not in content]
    if missing:
        raise Damaged(f"{path}: has no '{missing[0]}': it is not complete, or not of this program")
    return content


class Parameters(dict):
    """'Section/.../Key' -> text, every value that was in force.

    defaults: of those that differ, what would have been in force without an entry."""

    def __init__(self, values=(), defaults=()):
        super().__init__(values)
        self.defaults = dict(defaults)

    def differing(self):
        """[(name, value, default)] of all that differ from their defaults, in the order of the file."""
        return [(name, value, self.defaults[name]) for name, value in self.items() if name in self.defaults]


def read_parameters(path):
    """DIR/parameters.prm; empty if there is none. Errors: Damaged."""
    found, sections = Parameters(), []
    if not os.path.exists(path):
        return found
    try:
        with open(path, encoding="utf-8") as file:
            for line in file:
                words, _, comment = line.partition("#")
                words = words.strip()
                if words.startswith("subsection "):
                    sections.append(words.split(None, 1)[1])
                elif words == "end":
                    sections.pop()
                elif words.startswith("set "):
                    key, value = words[4:].split("=", 1)
                    name = "/".join([*sections, key.strip()])
                    found[name] = value.strip()
                    if comment.strip().startswith("default:"):
                        found.defaults[name] = comment.split(":", 1)[1].strip()
    except (IndexError, ValueError, OSError) as error:
        raise Damaged(f"{path}: is not what a run writes: {error}") from None
    return found


class Table(Mapping):
    """Columns by name: numbers as arrays of float, words as arrays of text.

    units: name -> unit ('' where the header has none). headers: name -> the header as it stands in the file. A last line that is
    cut short, as of a run that goes on, is left out."""

    def __init__(self, header, rows):
        self.units, self.headers, self.columns = {}, {}, {}
        for number, title in enumerate(header):
            name, _, unit = title.partition(" [")
            self.units[name], self.headers[name] = unit.rstrip("]"), title
            self.columns[name] = column([row[number] for row in rows])

    def __getitem__(self, name):
        """The column of this name, with or without its unit. Errors: Unknown."""
        name = name.partition(" [")[0]
        if name not in self.columns:
            raise Unknown(f"there is no column '{name}'; there is: {', '.join(self.columns)}")
        return self.columns[name]

    def __iter__(self):
        return iter(self.columns)

    def __len__(self):
        """How many columns there are."""
        return len(self.columns)

    @property
    def rows(self):
        """How many rows there are."""
        return len(next(iter(self.columns.values()))) if self.columns else 0

    def to_pandas(self):
        """As pandas.DataFrame, units in the names. Needs python3-pandas."""
        import pandas

        return pandas.DataFrame({self.headers[name]: values for name, values in self.columns.items()})


def column(words):
    try:
        return np.array([float(word) if word else np.nan for word in words])
    except ValueError:
        return np.array(words)


def read_table(path):
    """A CSV file with a header. None if there is no file. Errors: Damaged."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            lines = list(csv.reader(file))
    except FileNotFoundError:
        return None
    except (csv.Error, ValueError, OSError) as error:
        raise Damaged(f"{path}: cannot be read: {error}") from None
    if not lines or not lines[0]:
        raise Damaged(f"{path}: is empty")
    header, rows = lines[0], lines[1:]
    if rows and len(rows[-1]) != len(header):
        rows.pop()
    if any(len(row) != len(header) for row in rows):
        raise Damaged(f"{path}: has lines of different length")
    return Table(header, rows)
