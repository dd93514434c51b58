# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small runs and studies as the program writes them, made by hand: for tests of what reads them."""
import json
import pathlib
import re

import h5py
import numpy as np

PARAMETERS = """# Listing of Parameters
set Title = A small shield # default:
subsection Geometry
  set Symmetry = {symmetry}
end
subsection Mesh
  # edge of the finest cells
  set Finest cell = 0.5 cm # default: 0.1 cm
  set Levels = 5
end
subsection Materials
  set List = al 1, steel # default:
end
subsection Bodies
  set List = ball, bumper, wall # default:
  subsection ball
    set Shape = sphere # default:
    set Center = 0 cm, -0.5 cm # default:
    set Diameter = 6 mm # default:
    set Velocity = 0 km/s, 5 km/s # default: 0 cm/us, 0 cm/us
    set Material = al 1 # default:
  end
  subsection bumper
    set Shape = plate # default:
    set Front face = 0 cm # default:
    set Thickness = 0.5 cm # default:
    set Material = al 1 # default:
  end
  subsection wall
    set Shape = plate # default:
    set Front face = 3 cm # default:
    set Thickness = 0.5 cm # default:
    set Material = steel # default:
  end
end
subsection Stages
  set List = hit, flight # default:
  subsection hit
    set Mode = eulerian
  end
  subsection flight
    set Mode = lagrangian # default: eulerian
  end
end
"""

RESULTS = {
    "bumper": {"perforated": True, "hole_diameter_cm": 1.25, "crater_depth_cm": 0.5, "perforation_margin_cm": 1.0,
               "measured_at_us": 1.0},
    "flight": {"mass_g": 0.4, "mass_velocity_cm_per_us": 0.3, "cone_angle_deg": None, "angle_edges_deg": [0.0, 90.0, 180.0]},
    "wall": {"perforated": False, "hole_diameter_cm": 0.0, "crater_depth_cm": 0.1, "perforation_margin_cm": -0.4,
             "measured_at_us": 2.0},
}


def summary(**changes):
    """summary.json of the small run."""
    stage = {"mode": "eulerian", "start_us": 0.0, "end_us": 1.0, "steps": 10, "active_cells_max": 8, "elements": None,
             "dropped_mass_g": 0.0, "wall_s": 0.5, "cpu_s": 0.4, "cell_steps": 80.0, "dt_limits": {"sound": 9, "growth": 1}}
    return {
        "schema": 1, "program": {"version": "0.1.0", "commit": "abc", "build_type": "Release"}, "scene": "small.prm",
        "status": "completed", "reason": None, "resumable": False,
        "stages": [{"name": "hit", **stage},
                   {"name": "flight", **stage, "mode": "lagrangian", "start_us": 1.0, "end_us": 2.0, "elements": 2}],
        "ledger": {"mass_g": {"initial": 2.0, "final": 1.5, "left_domain": 0.0, "dropped": {"not debris": 0.5},
                              "closure_relative": 1e-15}},
        "results": RESULTS, "error_bars": None, "errors": None,
        "performance": {"wall_s": 1.0, "cpu_s": 0.8, "peak_rss_bytes": 1e8, "ranks": 1, "active_cell_steps": 160.0},
        "effects": {"voids": {"on": True, "number": None, "reason": "listed by the scene"},
                    "melting": {"on": False, "number": 0.25, "reason": "too cold"}},
        "counts": {"retries": 0, "warnings": 1, "events": {"slivers locked": {"number": 3.0, "size": 0.01, "unit": "g"}}},
        **changes,
    }


def boxes(lower, upper, cell):
    """Nodes and cells of a rectangle of square cells."""
    x, z = (np.arange(low, high + 0.5 * cell, cell) for low, high in zip(lower, upper))
    nodes = np.stack(np.meshgrid(x, z), axis=-1).reshape(-1, 2)
    first = (np.arange(len(z) - 1)[:, None] * len(x) + np.arange(len(x) - 1)).ravel()
    return nodes, np.stack([first, first + 1, first + 1 + len(x), first + len(x)], axis=1)


def write_fields(path, nodes, cells, cell_fields, velocity):
    with h5py.File(path, "w") as file:
        file["nodes"], file["cells"], file["velocity"] = nodes, cells.astype("i4"), velocity.astype("f4")
        for name, (unit, values) in cell_fields.items():
            file[re.sub(r"[^A-Za-z0-9]", "_", name)] = values.astype("f4")
            file[re.sub(r"[^A-Za-z0-9]", "_", name)].attrs["unit"] = unit


def small_fields(count, height):
    """All fields of a state in which the elements below the middle are 'al 1', the others half of it and half steel."""
    mixed = np.arange(count) >= count // 2
    steel, one = np.where(mixed, 0.5, 0.0), np.ones(count)
    return {
        "density": ("g/cm^3", (1 - steel) * 2.0 + steel * 8.0), "pressure": ("Mbar", np.linspace(-0.01, 0.2, count)),
        "solid fraction": ("1", np.linspace(0.1, 1.0, count)), "level": ("1", one), "rank": ("1", 0 * one),
        "al 1 volume fraction": ("1", 1 - steel), "al 1 density": ("g/cm^3", 2.0 * one),
        "al 1 temperature": ("K", 300.0 * one), "al 1 body ball": ("1", np.linspace(1.0, 0.0, count)),
        "steel volume fraction": ("1", steel), "steel density": ("g/cm^3", 8.0 * one), "steel temperature": ("K", 800.0 * one),
    }


GRID = """<Grid Name="{stage}" GridType="Uniform"><Time Value="{time}"/>
<Topology TopologyType="Quadrilateral" NumberOfElements="{count}"><DataItem Dimensions="{count} 4" Format="HDF">{file}:/cells</DataItem>
</Topology></Grid>
"""


def write_run(directory, fields=True, symmetry="axisymmetric", **changes):
    """A run of two stages, with three written times (0, 1 and 2 us) unless fields is false. CHANGES: of summary.json."""
    directory = pathlib.Path(directory)
    (directory / "gauges").mkdir(parents=True, exist_ok=True)
    (directory / "parameters.prm").write_text(PARAMETERS.format(symmetry=symmetry))
    (directory / "summary.json").write_text(json.dumps(summary(**changes)))
    (directory / "log.txt").write_text("Whipple 0.1.0\nwarning: <the log>\n")
    (directory / "statistics.csv").write_text(
        "time [us],stage,step,time step [us],active cells,kinetic energy [Mbar cm^3],internal energy [Mbar cm^3],mass [g]\n"
        "0.5,1,1,0.1,8,2,0.1,2\n1,1,2,0.1,8,1.5,0.4,2\n2,2,3,0.1")  # the last line is cut short
    (directory / "gauges" / "behind.csv").write_text("time [us],position 0 [cm],pressure [Mbar]\n0,0.1,nan\n1,0.1,0.2\n")
    if not fields:
        return directory
    (directory / "fields").mkdir(exist_ok=True)
    grids = ""
    for number, (stage, time) in enumerate((("hit", 0.0), ("flight", 1.0), ("flight", 2.0))):
        nodes, cells = boxes((0.0, time), (1.0, time + 2.0), 0.5)
        velocity = np.tile([0.0, 0.3, 0.0], (len(nodes), 1))
        write_fields(directory / f"fields/fields-{number:05d}.h5", nodes, cells, small_fields(len(cells), time), velocity)
        grids += GRID.format(stage=stage, time=time, count=len(cells), file=f"fields/fields-{number:05d}.h5")
    (directory / "fields.xdmf").write_text(
        f'<?xml version="1.0"?>\n<Xdmf><Domain><Grid GridType="Collection" CollectionType="Temporal">\n{grids}</Grid></Domain></Xdmf>\n')
    return directory


def point(label, cell, hole):
    return {"label": label, "choices": {"cell": f"{cell} cm"}, "cell_cm": cell, "ranks": 1, "program": "0.1.0 (abc)", "status": "completed",
            "reason": None, "wall_s": 0.1 / cell, "cpu_s": 0.1 / cell, "active_cell_steps": 1.0 / cell**2, "peak_rss_bytes": 1e8,
            "steps": 10, "results": {"bumper": {"hole_diameter_cm": hole}}, "headline_errors":
            [{"error": abs(hole - 1.0), "uncertainty": 0.01, "relative": True}]}


def write_study(directory):
    """A study of the small run on two meshes."""
    directory = pathlib.Path(directory)
    points = [point("cell=0.5cm", 0.5, 1.25), point("cell=0.25cm", 0.25, 1.1)]
    quantity = {"exact": False, "place": "bumper", "name": "hole_diameter_cm", "readable": "bumper hole diameter, cm", "unit": "cm"}
    estimate = {"verdict": "two levels", "order": None, "extrapolated": None, "error_bar": 0.45}
    for entry in points:
        write_run(directory / "points" / entry["label"])
    (directory / "study.json").write_text(json.dumps({
        "schema": 1, "study": "small.prm", "title": "Small shield, twice", "command": "./whipple study small.prm",
        "program": "0.1.0 (abc)", "headlines": [quantity], "points": points,
        "axes": [{"name": "cell", "parameters": ["Mesh/Finest cell"], "labels": ["0.5 cm", "0.25 cm"], "base": "0.25 cm",
                  "is_cell_axis": True}],
        "series": [{"label": "all", "points": [entry["label"] for entry in points], "errors": [], "verdicts": [],
                    "results": [{"quantity": quantity, "cells_cm": [0.5, 0.25], "values": [1.25, 1.1], "orders": [],
                                 "estimate": estimate}]}],
        "references": [], "choices": [], "tolerance": None}))
    (directory / "study.md").write_text("# Small shield, twice\n\nText.\n")
    return directory
