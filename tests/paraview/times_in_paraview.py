# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ParaView makes of a run's files: every written time of fields.xdmf (with each of its three XDMF readers) and of
fields.pvd has cells, also at hand-overs, where two states have one time, and fields of cells are cell data.

    pvpython times_in_paraview.py DIR      a run with Formats = hdf5, vtu
"""
import sys
import xml.etree.ElementTree as ElementTree

from paraview.simple import PVDReader, XDMFReader, Xdmf3ReaderS, Xdmf3ReaderT


def written_times(directory):
    """Times in fields.xdmf."""
    grids = ElementTree.parse(directory + "/fields.xdmf").getroot().iter("Time")
    return [float(time.get("Value")) for time in grids]


def check(reader, name, expected):
    reader.UpdatePipelineInformation()
    times = list(reader.TimestepValues)
    if times != expected:
        sys.exit(f"{name} has the times {times}, not {expected}")
    counts = []
    for time in times:
        reader.UpdatePipeline(time)
        information = reader.GetDataInformation()
        counts.append(information.GetNumberOfCells())
        if counts[-1] == 0:
            sys.exit(f"{name} shows no cells at {time!r} us")
        if not reader.CellData.GetArray("density [g/cm^3]"):
            sys.exit(f"{name} has no density of cells at {time!r} us; it has {reader.CellData.keys()}")
        if not reader.PointData.GetArray("velocity [cm/us]"):
            sys.exit(f"{name} has no velocity of points at {time!r} us")
    return counts


def main(directory):
    expected = written_times(directory)
    pairs = [a for a, b in zip(expected, expected[1:]) if b - a < 1e-9]
    if not pairs:
        sys.exit("the run has no hand-over, so this shows nothing")
    found = {}
    for reader in (Xdmf3ReaderS, Xdmf3ReaderT):
        found[reader.__name__] = check(reader(FileName=[directory + "/fields.xdmf"]), reader.__name__, expected)
    found["XDMFReader"] = check(XDMFReader(FileNames=[directory + "/fields.xdmf"]), "XDMFReader", expected)
    found["PVDReader"] = check(PVDReader(FileName=directory + "/fields.pvd"), "PVDReader", expected)
    if len({tuple(counts) for counts in found.values()}) != 1:
        sys.exit(f"the readers differ in the number of cells: {found}")
    print(f"{len(expected)} times, {len(pairs)} hand-overs, cells {found['PVDReader']}")


main(sys.argv[1])
