#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package python/whipple on a small run and a small study written by hand: numbers, units, names, and what is said when
something is not there or cut short."""
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
import whipple  # noqa: E402
from written_run import write_run, write_study  # noqa: E402


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def says(self, kind, words, action):
        """ACTION raises exactly KIND, in one line that holds WORDS."""
        with self.assertRaises(kind) as caught:
            action()
        self.assertIs(type(caught.exception), kind)
        self.assertIn(words, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))


class OfARun(InFolder):
    def setUp(self):
        super().setUp()
        self.run_ = whipple.open(write_run(self.path / "run"))

    def test_results_and_scene(self):
        self.assertEqual(self.run_.results["bumper"]["hole_diameter_cm"], 1.25)
        self.assertEqual(self.run_.status, "completed")
        self.assertFalse(self.run_.is_planar)
        self.assertEqual([(p.name, p.front, p.rear) for p in self.run_.plates], [("bumper", 0.0, 0.5), ("wall", 3.0, 3.5)])
        self.assertAlmostEqual(self.run_.contact_time, 0.2 / 0.5)  # 0.2 cm at 0.5 cm/us
        self.says(whipple.Unknown, "there is no place 'wal'; there is: bumper, flight, wall", lambda: self.run_.results["wal"])
        self.says(whipple.Unknown, "there is no result of wall 'hole'", lambda: self.run_.results["wall"]["hole"])

    def test_parameters_that_differ(self):
        self.assertEqual(self.run_.parameters["Mesh/Levels"], "5")
        self.assertIn(("Mesh/Finest cell", "0.5 cm", "0.1 cm"), self.run_.parameters.differing())
        self.assertNotIn("Mesh/Levels", [name for name, _, _ in self.run_.parameters.differing()])

    def test_tables(self):
        table = self.run_.statistics
        np.testing.assert_array_equal(table["kinetic energy"], [2.0, 1.5])  # without the line that is cut short
        self.assertEqual(table.units["kinetic energy"], "Mbar cm^3")
        self.assertEqual(table.rows, 2)
        self.assertTrue(np.isnan(self.run_.gauges["behind"]["pressure"][0]))
        self.says(whipple.Unknown, "there is no column 'nothing'", lambda: table["nothing"])
        self.assertIsNone(self.run_.history)
        (self.path / "run/history.csv").write_text("time_us,bumper hole_diameter_cm\n1,0.5\n2,\n")
        history = whipple.open(self.path / "run").history
        np.testing.assert_array_equal(history["bumper hole_diameter_cm"], [0.5, np.nan])

    def test_fields(self):
        field = self.run_.field("pressure", time=0.2, unit="GPa")
        self.assertEqual((field.elements.stage, field.elements.time, field.unit), ("hit", 0.0, "GPa"))
        np.testing.assert_allclose(np.asarray(field)[[0, -1]], [-1.0, 20.0], rtol=1e-6)
        self.assertEqual(len(field), 8)
        np.testing.assert_allclose(self.run_.field("speed", unit="km/s").values, 3.0, rtol=1e-6)
        # equal volumes of 2 and 8 g/cm^3 at 300 and 800 K
        np.testing.assert_allclose(self.run_.field("temperature").values, [300.0] * 4 + [700.0] * 4)
        np.testing.assert_allclose(self.run_.field("al 1 temperature").values, 300.0)
        self.says(whipple.Unknown, "there is no field 'voids'", lambda: self.run_.field("voids"))
        self.says(whipple.Unknown, "'Mbar' is a pressure, 'K' a temperature", lambda: self.run_.field("pressure", unit="K"))
        self.says(whipple.Unknown, "there is no stage 'landing'; there is: hit, flight", lambda: self.run_.elements(stage="landing"))

    def test_elements(self):
        elements = self.run_.elements(time=1.9)
        self.assertEqual((elements.number, elements.stage, len(elements)), (2, "flight", 8))
        np.testing.assert_allclose(elements.corners[0], [[0.0, 2.0], [0.5, 2.0], [0.5, 2.5], [0.0, 2.5]])
        np.testing.assert_allclose(elements.centres[0], [0.25, 2.25])
        shares = elements.body_shares(self.run_.bodies)
        np.testing.assert_allclose(shares.sum(axis=1), 1.0)
        np.testing.assert_allclose(shares[0], [1.0, 0.0, 0.0])
        np.testing.assert_allclose(shares[-1], [0.0, 0.2, 0.8], atol=1e-6)  # steel is the wall's alone
        self.assertEqual(self.run_.times, [0.0, 1.0, 2.0])
        self.assertEqual([(name, len(group)) for name, group in self.run_.stages()], [("hit", 1), ("flight", 2)])


class OfWhatIsNotThere(InFolder):
    def test_directories(self):
        self.says(whipple.NotARun, "there is no such directory", lambda: whipple.open(self.path / "nowhere"))
        self.says(whipple.NotARun, "neither the output of a run", lambda: whipple.open(self.path))

    def test_a_run_without_fields(self):
        run = whipple.open(write_run(self.path / "bare", fields=False))
        self.says(whipple.NotWritten, "set Output/Fields interval", lambda: run.field("density"))
        self.assertEqual(run.snapshots_or_none, [])

    def test_a_run_that_goes_on(self):
        run = whipple.open(write_run(self.path / "run"))
        (self.path / "run/summary.json").unlink()
        self.assertEqual(run.status, "not ended")
        self.says(whipple.NotWritten, "the run has not ended", lambda: run.results)

    def test_files_that_are_cut_short(self):
        write_run(self.path / "run")
        for name, read in (("fields/fields-00002.h5", lambda run: run.field("density")), ("fields.xdmf", lambda run: run.times),
                           ("summary.json", lambda run: run.results)):
            path = self.path / "run" / name
            content = path.read_bytes()
            path.write_bytes(content[:len(content) // 2])
            self.says(whipple.Damaged, name, lambda: read(whipple.open(self.path / "run")))
            path.write_bytes(content)
        (self.path / "run/fields/fields-00002.h5").unlink()
        self.says(whipple.Damaged, "named in fields.xdmf and not there", lambda: whipple.open(self.path / "run").field("density"))

    def test_an_empty_study(self):
        for content in ("{}", "[]", '{"study": "a"', ""):
            (self.path / "study.json").write_text(content)
            self.says(whipple.Damaged, "study.json", lambda: whipple.open(self.path))


class OfAStudy(InFolder):
    def test_points_and_series(self):
        study = whipple.open(write_study(self.path))
        self.assertEqual(study.title, "Small shield, twice")
        self.assertEqual(list(study.runs), ["cell=0.5cm", "cell=0.25cm"])
        self.assertEqual(study.runs["cell=0.5cm"].field("speed").unit, "cm/us")
        cells, holes = study.series("bumper", "hole_diameter_cm")["all"]
        np.testing.assert_array_equal(cells, [0.5, 0.25])
        np.testing.assert_array_equal(holes, [1.25, 1.1])
        self.assertEqual(study.estimates("bumper", "hole_diameter_cm")["all"]["error_bar"], 0.45)
        self.says(whipple.NotWritten, "no point has 'mass_g'", lambda: study.series("bumper", "mass_g"))
        self.says(whipple.Unknown, "there is no point 'x'; there is: cell=0.5cm", lambda: study.points["x"])


class OfUnits(unittest.TestCase):
    def test_conversion(self):
        self.assertAlmostEqual(whipple.convert(1.0, "Mbar", "GPa"), 100.0)
        self.assertAlmostEqual(whipple.convert(0.658, "cm/us", "km/s"), 6.58)
        self.assertAlmostEqual(whipple.convert(1.0, "Mbar cm^3", "J"), 1e5)
        self.assertAlmostEqual(whipple.convert(1.0, "g cm/us", "N s"), 10.0)
        self.assertEqual(whipple.units.readable("axial_momentum_g_cm_per_us"), ("axial momentum", "g cm/us"))
        self.assertEqual(whipple.units.readable("perforated"), ("perforated", ""))


if __name__ == "__main__":
    unittest.main()
