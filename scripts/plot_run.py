#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a run. Without options: of each written time the density (right half) and the bodies (left half), with what has been
measured; of each gauge its fields against time; results against time. Or one of:

    --field A[,B]            other quantities: A on the right, B on the left half (planar scenes: two panels):
                             density, solid, void fraction, speed, velocity (axial), pressure, temperature,
                             plastic strain, melt, damage, energy, bodies, mesh, or any field of the run
    --against OTHER          the same times of two runs side by side, in one window and scale
    --radiograph             what flash radiographs would show
    --strip                  all stages side by side, what is solid drawn solid
    --figure NAME            figures of the paper of 1993: all | handovers | 2a ... 4 (doc/output.md)
    --debris                 debris of each gap by angle and velocity, load on the last plate by radius
    --limit                  ballistic limit curve of the shield, with this shot and the tests near it

Which times: --time T, --stage NAME, --every N. Which part: --window R Z_MIN Z_MAX (planar: X_MIN X_MAX Y_MIN Y_MAX), else one that
follows what matters. --film makes a film of them as well. Colours have one scale for the whole run.

    scripts/plot_run.py DIR [--output FOLDER] [--format png | svg] [--planar] [--again] [options above]

Only what is new is drawn, unless --again. Needs python3-matplotlib and python3-h5py.
"""
import argparse
import os
import sys

from one_line import OneLine
from pictures import ballistic_limit, debris, figures, film, gauges, history, of_times
from pictures.drawn import Job, draw_all, remove_stale, state_of
from pictures.windows import Window

import whipple


def positive(text):
    number = int(text) if text.lstrip("+-").isdigit() else 0
    if number < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1")
    return number


def parse():
    parser = OneLine("plot", __doc__)
    parser.add_argument("directory", help="output directory of a run")
    parser.add_argument("--output", help="folder of the pictures; default DIR/pictures")
    parser.add_argument("--format", choices=["png", "svg"], default="png")
    parser.add_argument("--every", type=positive, default=1, metavar="N", help="only each N-th written time")
    parser.add_argument("--stage", metavar="NAME", help="only written times of this stage")
    parser.add_argument("--time", type=float, metavar="T", help="the written time nearest to this one, us")
    parser.add_argument("--window", type=float, nargs="+", metavar="CM", help="R Z_MIN Z_MAX, or X_MIN X_MAX Y_MIN Y_MAX")
    parser.add_argument("--planar", action="store_true", help="do not mirror; default: as parameters.prm says")
    parser.add_argument("--field", metavar="A[,B]", help="quantities to show; default density,bodies")
    parser.add_argument("--film", action="store_true", help="a film of the pictures: mp4 with ffmpeg, else gif")
    parser.add_argument("--again", action="store_true", help="draw also what is there already")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--against", metavar="OTHER", help="directory of another run")
    what.add_argument("--radiograph", action="store_true", help="areal density seen from the side")
    what.add_argument("--strip", action="store_true", help="all stages side by side")
    what.add_argument("--figure", metavar="NAME", help="all | handovers | the name of one: 2a, 3f, 4 ...")
    what.add_argument("--debris", action="store_true", help="debris by angle and velocity, load by radius")
    what.add_argument("--limit", action="store_true", help="ballistic limit curve with this shot and tests")
    arguments = parser.parse_args()
    if arguments.film and arguments.format != "png":
        parser.error("a film is made of png, not of svg")
    if arguments.field and (arguments.radiograph or arguments.strip or arguments.figure or arguments.debris or arguments.limit):
        parser.error("--field goes with pictures of written times and --against")
    arguments.names = names_of(parser, arguments.field)
    return parser, arguments


def names_of(parser, text):
    """(right, left) of --field."""
    names = tuple(name.strip().replace("_", " ") for name in (text or "density,bodies").split(","))
    if len(names) > 2 or not all(names):
        parser.error(f"--field '{text}': one quantity, or two with a comma between")
    return names if len(names) == 2 else (names[0], "bodies")


def window_of(parser, numbers, planar):
    """Errors: exit status 2."""
    if numbers is None:
        return None
    if len(numbers) == 3 and not (planar and numbers[0] <= 0):
        numbers = [0.0, *numbers]
    if len(numbers) != 4 or numbers[0] >= numbers[1] or numbers[2] >= numbers[3] or not planar and numbers[0] != 0.0:
        parser.error("--window: R Z_MIN Z_MAX with R > 0 and Z_MIN < Z_MAX; planar scenes X_MIN X_MAX Y_MIN Y_MAX")
    x_min, x_max, z_min, z_max = numbers
    width = x_max - x_min if planar else 2.0 * x_max
    grown = 0.5 * max(width - (z_max - z_min), 0.0)  # panels are square
    wider = 0.5 * max(z_max - z_min - width, 0.0)
    return Window(x_min - wider if planar else 0.0, x_max + wider, z_min - grown, z_max + grown)


def simple(run, kind, listed):
    """Jobs of [(file name, what draws it, its arguments)], which depend on what the run has written."""
    files = [run.path("summary.json"), run.path("history.csv"), run.path("parameters.prm")]
    states = tuple(state_of(path) for path in files) + ((run.snapshots_or_none and state_of(run.snapshots_or_none[-1].path)),)
    gauged = tuple(state_of(run.path("gauges", f"{name}.csv")) for name in run.gauges)
    return [Job(f"{name}.{kind}", draw, arguments, (name, states, gauged, run.is_planar)) for name, draw, arguments in listed]


def jobs_of(parser, arguments, run):
    """What is to be drawn. Errors: whipple.WhippleError."""
    kind = arguments.format
    window = window_of(parser, arguments.window, run.is_planar)
    if arguments.debris:
        return simple(run, kind, debris.pictures(run))
    if arguments.limit:
        return simple(run, kind, [("ballistic_limit", ballistic_limit.picture, (run,))])
    beside = simple(run, kind, gauges.pictures(run) + history.pictures(run))
    if beside and not run.snapshots_or_none and not (arguments.strip or arguments.figure or arguments.radiograph or arguments.against):
        return beside
    snapshots = of_times.chosen(run, arguments.every, arguments.stage, arguments.time)
    if arguments.strip:
        return simple(run, kind, [("strip", figures.strip, (run,))])
    if arguments.figure:
        return simple(run, kind, figures.by_name(arguments.figure, run))
    if arguments.radiograph:
        return of_times.radiographs(run, snapshots, window, kind)
    if arguments.against:
        other = run_of(arguments.against)
        return of_times.against(run, other, snapshots, arguments.names, window, kind)
    times = of_times.Times(run, arguments.names, window)
    usual = not (arguments.field or arguments.time is not None or arguments.stage or arguments.film)
    return [times.frame(snapshot, kind) for snapshot in snapshots] + (beside if usual else [])


def run_of(directory):
    run = whipple.open(directory)
    if not isinstance(run, whipple.Run):
        raise whipple.NotARun(f"{directory}: is a study, not a run")
    return run


def main():
    parser, arguments = parse()
    try:
        run = run_of(arguments.directory)
        run.is_planar = run.is_planar or arguments.planar
        folder = arguments.output or run.path("pictures")
        jobs = jobs_of(parser, arguments, run)
        if not arguments.output:
            remove_stale(folder, len(run.snapshots_or_none))
        paths, drawn = draw_all(jobs, folder, arguments.again)
        if arguments.film:
            print(film.make(paths, os.path.join(folder, f"film-{jobs[0].file.rsplit('-', 1)[0]}")))
        print(f"{len(paths)} pictures in {folder}: {drawn} drawn, {len(paths) - drawn} as they were", file=sys.stderr)
    except KeyboardInterrupt:
        sys.exit(130)
    except (whipple.WhippleError, OSError) as error:
        words = str(error)
        print(words if words.startswith(arguments.directory) else f"{arguments.directory}: {words}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
