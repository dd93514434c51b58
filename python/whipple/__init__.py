# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run or a study of Whipple has left, as numbers and arrays. Needs numpy and h5py.

    import whipple
    run = whipple.open("output/whipple_shield")
    run.results["wall"]["perforated"]                     # doc/results.md
    run.statistics["kinetic energy"], run.statistics.units["kinetic energy"]
    run.field("pressure", time=1.5, unit="GPa").values    # one an element
    run.elements(time=1.5).corners                        # [n, 4, 2], cm
    run.gauges["behind the bumper"]["pressure"]
    study = whipple.open("output/whipple")
    study.points, study.runs, study.series("bumper", "hole_diameter_cm")

Numbers are in the program's units, cm, g, us and Mbar, unless another is asked for. Every error is a WhippleError whose text
is one line.
"""
import os

from .errors import Damaged, NotARun, NotWritten, Unknown, WhippleError
from .run import Run
from .snapshot import Field, Snapshot
from .study import Study
from .units import convert

__all__ = ["open", "Run", "Study", "Snapshot", "Field", "convert", "WhippleError", "NotARun", "Damaged", "NotWritten", "Unknown"]


def open(directory):
    """The Run or the Study in a directory. Errors: NotARun if it is neither, Damaged if its first file cannot be read."""
    directory = os.fspath(directory)
    if os.path.exists(os.path.join(directory, "study.json")):
        return Study(directory)
    if os.path.exists(os.path.join(directory, "parameters.prm")):
        return Run(directory)
    if not os.path.isdir(directory):
        raise NotARun(f"{directory}: there is no such directory")
    raise NotARun(f"{directory}: is neither the output of a run (parameters.prm) nor that of a study (study.json)")
