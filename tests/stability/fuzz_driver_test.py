#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The driver of random scenes: what it makes, and that its record survives being ended. In place of the program stands a
script that says how a scene ended."""
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True

import fuzz
import fuzz_record
import fuzz_scene

DRIVER = pathlib.Path(__file__).resolve().with_name("fuzz.py")

# Scenes of two and three ranks crash, those of one rank end; a file 'wait' holds the script up, 'mended' mends the crash.
PROGRAM = """#!/bin/sh
[ "$1" = --version ] && echo 'Whipple 0.1.0 (1234567)' && exit 0
while [ -e '{folder}/wait' ]; do sleep 0.05; done
[ "$4" = 1 ] || [ -e '{folder}/mended' ] || exit 139
mkdir -p "$6"
echo '{{"reason": null, "ledger": {{"mass_g": {{"closure_relative": 0}}, "axial_momentum_g_cm_per_us": {{"closure_relative": 0}},
  "energy_Mbar_cm3": {{"closure_relative": 0, "initial_kinetic": 1, "kinetic": 1}}}}}}' > "$6/summary.json"
"""


class Scenes(unittest.TestCase):
    def test_same_seed_same_scene(self):
        self.assertEqual(fuzz_scene.make(5, 17), fuzz_scene.make(5, 17))
        self.assertNotEqual(fuzz_scene.make(5, 17), fuzz_scene.make(5, 18))
        self.assertNotEqual(fuzz_scene.make(5, 17), fuzz_scene.make(6, 17))

    def test_predicted_work_is_bounded(self):
        for work in (fuzz_scene.LEAST_WORK, fuzz_scene.WORK):
            for number in range(200):
                scene, _ = fuzz_scene.make(5, number, work)
                (_, low), (width, high) = (fuzz_scene.lengths(scene["Geometry"][f"{end} corner"]) for end in ("Lower", "Upper"))
                cell, bodies = fuzz_scene.lengths(scene["Mesh"]["Finest cell"])[0], scene["Bodies"]
                bodies = {name: body for name, body in bodies.items() if isinstance(body, dict)}
                cells = fuzz_scene.cells_of(bodies, scene["Geometry"]["Symmetry"] == "planar", cell, width, high - low)
                self.assertLessEqual(cells * fuzz_scene.STEPS[0], work)

    def test_moving_meshes_mostly_have_void_laws(self):
        without = moving = 0
        for number in range(1000):
            scene, _ = fuzz_scene.make(5, number)
            if any(stage["Mode"] == "lagrangian" for stage in fuzz_scene.members(scene, "Stages")):
                moving += 1
                without += any(m.get("Void law", "none") == "none" and m["Equation of state"] != "ideal gas"
                               for m in fuzz_scene.members(scene, "Materials"))
        self.assertGreater(moving, 700)
        self.assertGreater(without, 0)  # a few stay, and must stop in clear words
        self.assertLess(without, 0.05 * moving)

    def test_two_hundred_scenes_try_every_kind(self):
        tried = set().union(*(fuzz_scene.kinds(*fuzz_scene.make(1, number)) for number in range(200)))
        for group, number in (("geometry", 2), ("ranks", 3), ("fastest body", 5), ("stages", 6), ("cohesion", 3), ("representation", 2),
                              ("equation of state", 7), ("void law", 3), ("strength", 4), ("failure", 2), ("effect", 7), ("shape", 3)):
            self.assertEqual(len({kind for g, kind in tried if g == group}), number, group)


class Numbers(unittest.TestCase):
    def test_text_and_back(self):
        for numbers, text in ((set(), ""), ({0}, "0"), ({0, 1, 2, 5}, "0-2, 5"), ({3, 7, 8}, "3, 7-8")):
            self.assertEqual(fuzz_record.text_of(numbers), text)
            self.assertEqual(fuzz_record.numbers_of(text), numbers)


class Reasons(unittest.TestCase):
    def test_scenes_that_stop_for_one_reason_stand_together(self):
        record = fuzz_record.Record(None, {"build": "Release", "seed": 1})
        for number, cells in ((7, "3"), (2, "14"), (5, "1.5e-3")):
            outcome = fuzz.Outcome(None, 3, f"'m{number}' fills {cells} cells", 0.5)
            record.add(number, outcome, {("geometry", "planar")}, "1234567")
        self.assertEqual(record.entry["stopped"], {"* fills * cells": "2, 5, 7"})
        self.assertEqual(fuzz_record.stopped_scenes(record.entry), {"* fills * cells": 3})
        self.assertEqual(record.entry["classes"], {"below 1 s": 3})


class Driver(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        program = self.folder / "program"
        program.write_text(PROGRAM.format(folder=self.folder), encoding="utf-8")
        program.chmod(0o755)
        self.command = [sys.executable, str(DRIVER), str(program), "--seed", "2", "--record", str(self.folder / "record.json"),
                        "--keep", str(self.folder / "kept")]
        self.crash = [n for n in range(12) if fuzz_scene.make(2, n)[1] > 1]

    def run_driver(self, *options):
        return subprocess.run([*self.command, *options], capture_output=True, text=True, timeout=100)

    def entry(self):
        entries = json.loads((self.folder / "record.json").read_text(encoding="utf-8"))
        self.assertEqual(len(entries), 1)
        return entries[0]

    def test_goes_on_where_it_stopped_and_tries_failures_again(self):
        self.assertTrue(0 < len(self.crash) < 12)
        self.run_driver("--scenes", "5")
        self.assertEqual(self.entry()["numbers"], "0-4")
        again = self.run_driver("--scenes", "12", "--jobs", "3")
        self.assertIn("7 scenes: 5-11", again.stdout)
        self.assertEqual(again.returncode, 1)
        entry = self.entry()
        self.assertEqual(entry["numbers"], "0-11")
        self.assertEqual(sorted(failure["scene"] for failure in entry["failed"]), self.crash)
        self.assertEqual(entry["completed"], 12 - len(self.crash))
        self.assertEqual(sum(entry["kinds"]["geometry"].values()), 12)
        self.assertEqual(entry["commits"], {"1234567": 12})
        (self.folder / "mended").touch()
        self.assertEqual(self.run_driver("--failed").returncode, 0)
        self.assertEqual(self.entry()["failed"], [])
        self.assertEqual(self.entry()["completed"], 12)
        self.assertEqual(sum(self.entry()["kinds"]["geometry"].values()), 12)

    def test_ended_in_the_middle_keeps_what_it_found(self):
        self.run_driver("--scenes", "3")
        (self.folder / "wait").touch()
        process = subprocess.Popen([*self.command, "--scenes", "12"], stdout=subprocess.PIPE, text=True)
        self.assertIn("9 scenes: 3-11", process.stdout.readline())
        time.sleep(0.5)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        self.assertEqual(self.entry()["numbers"], "0-2")  # the scene that ran is no result
        (self.folder / "wait").unlink()
        self.assertIn("9 scenes: 3-11", self.run_driver("--scenes", "12").stdout)
        self.assertEqual(self.entry()["numbers"], "0-11")


if __name__ == "__main__":
    unittest.main()
