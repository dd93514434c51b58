#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run random valid scenes briefly and look for what must never happen: a crash, something that is not a number, a hang, an
open ledger, kinetic energy from nowhere, results that depend on the number of ranks, a stop without a clear reason.

    tests/stability/fuzz.py build/whipple                       20 scenes of a new seed, which is printed
    tests/stability/fuzz.py build/whipple --seed 7 --scenes 10000 --jobs 2 --record FILE.json
                                                                written after every scene: the same command goes on with it
    tests/stability/fuzz.py build/whipple --seed 7 --record FILE.json --failed       those again that failed, as the record says
    tests/stability/fuzz.py build/whipple --seed 7 --only 133   one of them again, its output kept
    tests/stability/fuzz.py build/whipple --seed 7 --only 133 --reduce      the smallest scene that fails the same way

Each scene that fails is left in --keep DIR (default fuzz_failures) as a .prm file whose first lines say what happened and how
to repeat it. Exit status: 0 nothing failed, 1 something did. Standard library only.
"""
import argparse
import collections
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.dont_write_bytecode = True  # nothing into the source folder

import fuzz_record
import fuzz_reduce
import fuzz_scene

CLOSURE = 1e-12           # of mass, momentum, energy
GROWTH = 1 + 1e-9         # of kinetic energy, over all that bodies brought
PATIENCE = 60             # times the limit on processor time that a run may take on the wall: the machine may be shared
PLAIN_SUMS = ("viscous work", "hourglass work", "plastic work", "remap loss", "mass left domain",
              "closure")  # equal to round-off only (doc/limitations.md)

NOT_ALWAYS_NUMBERS = ("time step set by", "set at")  # what set the time step, and where, if it was a cell

ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_hwloc_base_binding_policy="none",
                   OMPI_MCA_btl_vader_single_copy_mechanism="none", OMPI_MCA_mpi_yield_when_idle="1")
ENVIRONMENT.setdefault("ASAN_OPTIONS", "detect_leaks=0")  # MPI libraries never give back all they took

Outcome = collections.namedtuple("Outcome", "failure status reason processor")  # failure: (kind, detail) or None; seconds


class Ended(Exception):
    """The driver is to end: what runs is no result."""


def processes_with(mark):
    """Processes whose command line holds a mark."""
    found = []
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if mark.encode() in (folder / "cmdline").read_bytes():
                found.append(int(folder.name))
        except OSError:
            pass  # it has just ended
    return found


def processor_seconds(pid):
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    except (OSError, IndexError):
        return 0.


def numbers_of(value):
    """All numbers in a JSON value."""
    if isinstance(value, dict):
        return [n for v in value.values() for n in numbers_of(v)]
    if isinstance(value, list):
        return [n for v in value for n in numbers_of(v)]
    return [float(value)] if isinstance(value, (int, float)) else []


def statistics(directory):
    """Columns of statistics.csv without their units; None if there is no step."""
    try:
        rows = list(csv.reader((directory / "statistics.csv").read_text(encoding="utf-8").splitlines()))
    except OSError:
        return None
    if len(rows) < 2:
        return None
    names = [name.split(" [")[0] for name in rows[0]]
    return {name: [row[i] for row in rows[1:] if len(row) == len(names)] for i, name in enumerate(names)}


def sanitizer_report(text):
    for pattern in (r"ERROR: AddressSanitizer: (\S+)", r"(\S+:\d+):\d+: runtime error: (.*)", r"An error occurred in line <(\d+)> of file <(\S+)>",
                    r"Assertion .*failed", r"terminate called after throwing (.*)"):
        found = re.search(pattern, text)
        if found:
            return found.group(0)[:160]
    return None


def fastest_square(scene):
    """Largest square of a body's velocity, (cm/us)^2."""
    bodies = (body for body in scene["Bodies"].values() if isinstance(body, dict) and "Velocity" in body)
    return max((sum((0.1 * float(part.split()[0])) ** 2 for part in body["Velocity"].split(",")) for body in bodies), default=0.)


def judge(status, text, directory, scene):
    """(kind, detail) of what is wrong with a run, or None; and the reason why it stopped."""
    report = sanitizer_report(text)
    if report:
        return ("assertion or sanitizer", report), None
    if status not in (0, 3):
        lines = text.strip().splitlines() or ["nothing said"]
        said = lines[-1].replace(f"{directory.parent}/", "")[:200]
        return ("refused" if status == 2 else f"crash, status {status}", said), None
    try:
        summary = json.loads((directory / "summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        return ("no summary", str(error)), None
    reason = summary.get("reason")
    if status == 3 and len(reason or "") < 20:
        return ("stopped without a clear reason", str(reason)), reason
    if not all(map(math.isfinite, numbers_of(summary))):
        return ("not a number in the summary", ""), reason
    energy = summary["ledger"]["energy_Mbar_cm3"]
    allowed = (energy.get("initial_kinetic", 0.) + max(0., energy.get("initial_internal", 0.))) * GROWTH
    columns = statistics(directory)
    if columns:
        values = {name: [float(v) for v in column] for name, column in columns.items() if not name.startswith(NOT_ALWAYS_NUMBERS)}
        for name, column in values.items():
            if not all(map(math.isfinite, column)):
                return ("not a number in the statistics", name), reason
        # a body that touches a transmitting side and moves away from it goes on beyond it, and comes in
        allowed += 0.5 * fastest_square(scene) * max(0., -min(values["mass left domain"]))
        kinetic = max(values["kinetic energy"])
        if kinetic > allowed:
            return ("kinetic energy grows", f"x {kinetic / max(allowed, 1e-300):.6g} of what the bodies brought"), reason
        for name in ("mass closure", "axial momentum closure", "energy closure"):
            if max(values[name]) > CLOSURE:
                return ("open ledger", f"{name} {max(values[name]):.3g}"), reason
    for name in ("mass_g", "axial_momentum_g_cm_per_us", "energy_Mbar_cm3"):
        closure = summary["ledger"][name]["closure_relative"]
        if closure is not None and closure > CLOSURE:
            return ("open ledger", f"{name} {closure:.3g} at the end"), reason
    if energy.get("kinetic", 0.) > allowed:
        return ("kinetic energy grows", f"x {energy['kinetic'] / max(allowed, 1e-300):.6g} at the end"), reason
    if reason and re.search(r"\bnan\b|\binf\b", reason):
        return ("stopped at something that is not a number", reason[:200]), reason
    if reason and re.search(r"lost|closure|conserv|gained|changed the", reason):
        return ("stopped by an open ledger", reason[:200]), reason
    return None, reason


def differing_column(one, other):
    """The first column of the statistics that is not the same to the last bit, without those that are plain sums."""
    if one is None or other is None:
        return None if one is other else "the number of steps"
    for name, column in one.items():
        if not any(plain in name for plain in PLAIN_SUMS) and column != other[name]:
            return name
    return None


class Driver:
    def __init__(self, options):
        self.options = options
        self.program = str(pathlib.Path(options.program).resolve())
        self.ending = threading.Event()

    def command(self, scene_file, ranks, directory):
        return [self.program, "run", str(scene_file), "-n", str(ranks), "--output", str(directory)]

    def start(self, scene, ranks, folder, name):
        """Run a scene: (status, text, directory, processor seconds); status None after the limit on processor time."""
        file, directory = folder / f"{name}.prm", folder / name
        file.write_text(fuzz_scene.text(scene), encoding="utf-8")
        with open(folder / f"{name}.txt", "w+", encoding="utf-8", errors="replace") as output:
            process = subprocess.Popen(self.command(file, ranks, directory), cwd=folder, env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                                       stdout=output, stderr=subprocess.STDOUT)
            status, processor = self.wait(process, str(directory))
            output.seek(0)
            return status, output.read(), directory, processor

    def wait(self, process, mark):
        """Exit status of a run, None if it was ended because it took too long, and the processor seconds of all its ranks, which
        have `mark` in their command."""
        began, late = time.time(), False
        while True:
            ended, status, usage = os.wait4(process.pid, os.WNOHANG)
            if ended:
                process.returncode = os.waitstatus_to_exitcode(status)
                if self.ending.is_set():
                    raise Ended
                return None if late else process.returncode, usage.ru_utime + usage.ru_stime
            elapsed = time.time() - began
            time.sleep(0.02 if elapsed < 1 else 0.2)
            used = max(map(processor_seconds, processes_with(mark)), default=0.) if elapsed > self.options.timeout else 0.
            if used > self.options.timeout or elapsed > PATIENCE * self.options.timeout or self.ending.is_set():
                late = True
                self.kill(mark)

    @staticmethod
    def kill(mark):
        for pid in processes_with(mark):
            try:
                os.kill(pid, signal.SIGKILL)
            except OSError:
                pass  # it has just ended

    def hang(self, directory):
        columns = statistics(directory)
        steps = len(columns["step"]) if columns else 0
        where = f"after {steps} steps, dt {columns['time step'][-1]} us" if steps else "before the first step"
        slow = columns and float(columns["time step"][-1]) < 1e-3 * max(map(float, columns["time step"]))
        return ("collapse of the time step" if slow else "hang", f"{where}, {self.options.timeout:g} s")

    def run(self, scene, ranks, compare=True):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="fuzz"))
        try:
            status, text, directory, processor = self.start(scene, ranks, folder, "scene")
            failure, reason = (self.hang(directory), None) if status is None else judge(status, text, directory, scene)
            if failure is None and ranks > 1 and compare:
                again, _, alone, more = self.start(scene, 1, folder, "alone")
                processor += more
                column = differing_column(statistics(directory), statistics(alone))
                if again != status or column:
                    failure = ("depends on the number of ranks", f"status {status} and {again}, column '{column}'")
            return Outcome(failure, status, reason, processor)
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def keep(self, scene, ranks, failure, name):
        self.options.keep.mkdir(parents=True, exist_ok=True)
        file = self.options.keep / f"{name}.prm"
        head = [f"# {failure[0]}: {failure[1]}", f"#   whipple run {file.name} -n {ranks}",
                f"#   fuzz.py {self.options.program} --seed {self.options.seed} --work {self.options.work} --only "
                f"{name.split('-')[1]} --reduce"]
        file.write_text("\n".join(head) + "\n" + fuzz_scene.text(scene), encoding="utf-8")
        return file

    def one(self, number):
        scene, ranks = fuzz_scene.make(self.options.seed, number, self.options.work)
        outcome = self.run(scene, ranks)
        file = self.keep(scene, ranks, outcome.failure, f"{self.options.seed}-{number}") if outcome.failure else None
        return number, outcome, file, fuzz_scene.kinds(scene, ranks)

    def reduce(self, number):
        scene, ranks = fuzz_scene.make(self.options.seed, number, self.options.work)
        outcome = self.run(scene, ranks)
        if not outcome.failure:
            sys.exit(f"scene {number} of seed {self.options.seed} does not fail")
        kind = outcome.failure[0]
        kept = lambda scene, ranks, failure: self.keep(scene, ranks, failure, f"{self.options.seed}-{number}-reduced")
        kept(scene, ranks, outcome.failure)

        def fails(candidate, candidate_ranks):
            result = self.run(candidate, candidate_ranks, compare=kind.startswith("depends"))
            if result.failure and likeness(result.failure) == likeness(outcome.failure):
                kept(candidate, candidate_ranks, result.failure)
                return True
            return False

        fuzz_reduce.reduce(scene, ranks, fails)
        print(f"{kind}: {self.options.keep}/{self.options.seed}-{number}-reduced.prm")


def likeness(failure):
    """What a smaller scene has in common with one that fails: the kind; if the scene is refused, the reason, too."""
    kind, detail = failure
    return (kind, fuzz_record.kind_of(detail) if kind == "refused" else "")


def commit_of(program):
    version = subprocess.run([program, "--version"], capture_output=True, text=True, env=ENVIRONMENT).stdout
    return (re.search(r"[0-9a-f]{7,40}(-dirty)?", version) or ["unknown"])[0]


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seed", type=int, help="default: from the clock")
    parser.add_argument("--scenes", type=int, default=20)
    parser.add_argument("--first", type=int, default=0, help="number of the first scene")
    parser.add_argument("--only", type=int, help="this scene only")
    parser.add_argument("--reduce", action="store_true", help="with --only: make the scene smaller while it fails")
    parser.add_argument("--jobs", type=int, default=1, help="scenes at a time")
    parser.add_argument("--timeout", type=float, default=60, help="processor seconds a rank may take")
    parser.add_argument("--budget", type=float, default=math.inf, help="seconds after which no further scene starts")
    parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path("fuzz_failures"), help="where failing scenes go")
    parser.add_argument("--work", type=int, default=fuzz_scene.WORK, help="cell steps of a scene, as predicted (default %(default)s)")
    parser.add_argument("--record", type=pathlib.Path, help="keep what is found in this JSON file, and go on with what it has")
    parser.add_argument("--failed", action="store_true", help="with --record: run those again that failed")
    parser.add_argument("--build", default="Release", help="name of the build in the record")
    options = parser.parse_args()
    if options.seed is None:
        options.seed = random.SystemRandom().randrange(10**6)
    if options.only is not None:
        options.first, options.scenes = options.only, 1
    if options.work < fuzz_scene.LEAST_WORK:
        parser.error(f"--work {options.work}: {fuzz_scene.LEAST_WORK} or more")
    if options.failed and not options.record:
        parser.error("--failed: needs a --record")
    return options


def numbers_to_run(options, record):
    if options.failed:
        return sorted(record.failed())
    if options.only is not None:
        return [options.only]
    return [number for number in range(options.first, options.first + options.scenes) if number not in record.numbers]


def main():
    options = parse()
    driver = Driver(options)
    if options.reduce:
        return driver.reduce(options.only)
    record = fuzz_record.Record(options.record, {"build": options.build, "seed": options.seed,
                                                 "generator": fuzz_scene.GENERATOR, "work": options.work})
    numbers, commit, began, failed = numbers_to_run(options, record), commit_of(driver.program), time.time(), 0
    print(f"seed {options.seed}, {len(numbers)} scenes: {fuzz_record.text_of(numbers)}", flush=True)
    for ending in (signal.SIGTERM, signal.SIGINT):
        signal.signal(ending, lambda *_: driver.ending.set())
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        go_on = lambda: time.time() - began < options.budget and not driver.ending.is_set()
        started = [pool.submit(lambda number: driver.one(number) if go_on() else None, number) for number in numbers]
        for done in concurrent.futures.as_completed(started):
            if isinstance(done.exception(), Ended) or done.result() is None:  # no time was left
                continue
            number, outcome, file, kinds = done.result()
            record.add(number, outcome, kinds, commit)
            if outcome.failure:
                failed += 1
                print(f"scene {number}: {outcome.failure[0]}: {outcome.failure[1]}  ({file})", flush=True)
    print("\n".join(record.lines()))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
