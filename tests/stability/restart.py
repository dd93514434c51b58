#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kill a chain at random moments (SIGKILL, or SIGTERM), let it go on, and compare it with the chain that was left alone.

    restart.py PROGRAM SCENE [--moments N] [--seed S] [--cell '0.032 cm'] [--set 'Section/Name = value']...

It writes checkpoints as fast as it can, so that many moments fall into one. Numbers of ranks change from part to part. The final
states must have the same checksums of mesh and fields, the same results, counts and tables of statistics and gauges. The seed is printed.
"""
import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time

COLUMNS = 9  # of statistics.csv: those that are the same on any number of ranks
# In the way of sphere and cloud, and riding in the sphere.
GAUGES = [
    "Gauges/List = way, rider",
    "Gauges/way/Point = 0.03 cm, 2 cm",
    "Gauges/rider/Kind = material",
    "Gauges/rider/Point = 0.03 cm, -0.2 cm",
    "Gauges/rider/Interval = 0.1 us",
]
STAGE_KEYS = ("name", "start_us", "end_us", "steps", "active_cells_max", "elements", "cell_steps", "dt_limits")


def descendants(process):
    """A process and all below it: ranks have sessions of their own."""
    children = {}
    for name in os.listdir("/proc"):
        if name.isdigit():
            try:
                with open(f"/proc/{name}/stat", encoding="utf8") as file:
                    parent = int(file.read().rpartition(")")[2].split()[1])
            except OSError:
                continue
            children.setdefault(parent, []).append(int(name))
    found, front = [process], [process]
    while front:
        front = [child for parent in front for child in children.get(parent, [])]
        found += front
    return found


def run(words, seconds=None, how=None):
    """Run to the end, or end it after that many seconds. Returns the exit status."""
    with open("output.txt", "a", encoding="utf8") as log:
        process = subprocess.Popen(words, stdout=log, stderr=log, start_new_session=True)
        try:
            return process.wait(seconds)
        except subprocess.TimeoutExpired:
            pass
        if how == signal.SIGKILL:
            for one in descendants(process.pid):
                try:
                    os.kill(one, how)
                except ProcessLookupError:
                    pass
        else:
            process.send_signal(how)
        return process.wait()


def newest(directory):
    folder = f"{directory}/checkpoints"
    name = max(name for name in os.listdir(folder) if name.isdigit())
    with open(f"{folder}/{name}/contents.json", encoding="utf8") as file:
        return json.load(file)


def outcome(directory):
    """What must be the same."""
    with open(f"{directory}/summary.json", encoding="utf8") as file:
        summary = json.load(file)
    with open(f"{directory}/statistics.csv", encoding="utf8") as file:
        rows = [",".join(line.split(",")[:COLUMNS]) for line in file]
    gauges = {}
    for name in sorted(os.listdir(f"{directory}/gauges")):
        with open(f"{directory}/gauges/{name}", encoding="utf8") as file:
            gauges[name] = file.read()
    counts = summary["counts"]
    return {
        "fields": newest(directory)["datasets"],
        "status": summary["status"],
        "results": summary["results"],
        "stages": [{key: stage.get(key) for key in STAGE_KEYS} for stage in summary["stages"]],
        "counts": {key: counts[key] for key in ("retries", "releases", "breaks", "rezones", "warnings")},
        "events": {what: event["number"] for what, event in counts["events"].items()},
        "statistics": rows,
        "gauges": gauges,
    }


def killed(program, start, duration, rng):
    """A chain that is ended again and again until it is done. Returns (ranks, exit status) of its parts."""
    shutil.rmtree("killed", ignore_errors=True)
    parts = []
    status = None
    while status != 0 and len(parts) < 20:
        ranks = rng.choice([1, 1, 2, 3])
        begun = os.path.exists("killed/parameters.prm")
        words = [program, "run"] + (["--resume", "killed"] if begun else start + ["--output", "killed"]) + ["-n", str(ranks)]
        how = rng.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM])
        seconds = None if len(parts) >= 2 else rng.uniform(0.1, 1.0) * duration * (1 if ranks == 1 else 2)
        status = run(words, seconds, how)
        parts.append((ranks, status))
        if seconds is None and status != 0:
            break
    return parts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scene")
    parser.add_argument("--moments", type=int, default=5)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cell", default="0.032 cm")
    parser.add_argument("--set", action="append", default=[])
    options = parser.parse_args()
    print(f"seed {options.seed}, {options.moments} moments, cells of {options.cell}", flush=True)

    overrides = [f"Mesh/Finest cell = {options.cell}", "Output/Checkpoint interval = 1 ms"] + GAUGES + options.set
    start = [options.scene] + [word for override in overrides for word in ("--set", override)]
    shutil.rmtree("whole", ignore_errors=True)
    begin = time.time()
    if run([options.program, "run"] + start + ["--output", "whole"]) != 0:
        sys.exit("the chain that was left alone did not end: see output.txt")
    duration = time.time() - begin
    expected = outcome("whole")

    failures = 0
    rng = random.Random(options.seed)
    for moment in range(options.moments):
        parts = killed(options.program, start, duration, rng)
        if parts[-1][1] != 0:
            differences = [f"exit status {parts[-1][1]}"]
        else:
            found = outcome("killed")
            differences = [key for key in expected if found[key] != expected[key]]
        failures += bool(differences)
        print(f"{moment}: {parts} {'differs in ' + ', '.join(differences) if differences else 'same'}", flush=True)
    if failures:
        sys.exit(f"{failures} of {options.moments} differ")


if __name__ == "__main__":
    main()
