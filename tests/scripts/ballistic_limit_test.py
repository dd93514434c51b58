#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Christiansen's limit of the shield of the paper of 1993, by hand; the tests of the table; what a run's parameters say."""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from pictures import ballistic_limit as limit  # noqa: E402
from whipple import Unknown  # noqa: E402

PAPER = limit.Shield(bumper=0.081, bumper_density=2.8, standoff=10.16, wall=0.127, wall_yield=50.0)


class BallisticLimit(unittest.TestCase):
    def test_shield_of_the_paper(self):
        for velocity, angle, diameter in ((6.58, 0, 0.313), (7.0, 0, 0.335), (6.58, 30, 0.272), (6.58, 45, 0.238),
                                          (6.58, 60, 0.243)):
            self.assertAlmostEqual(PAPER.critical_diameter(velocity, 2.7, angle), diameter, delta=0.0015)

    def test_continuous_at_both_ends(self):
        for velocity in (3.0, 7.0):
            self.assertAlmostEqual(PAPER.critical_diameter(velocity - 1e-9, 2.7), PAPER.critical_diameter(velocity + 1e-9, 2.7),
                                   delta=1e-8)

    def test_table_knows_the_shot_of_the_paper(self):
        tests = {test.name: test for test in limit.normal_aluminium_tests()}
        self.assertGreater(len(tests), 300)
        shot = tests["A240"]
        self.assertFalse(shot.perforated)
        self.assertEqual((shot.diameter, shot.velocity), (0.318, 6.58))
        self.assertTrue(shot.is_near(PAPER))
        self.assertAlmostEqual(shot.excess(), 0.318 / 0.313, delta=0.01)
        self.assertFalse(tests["A231"].is_near(PAPER))  # standoff 5.08 cm

    def test_parameters_of_a_run(self):
        values = {"Bodies/List": "ball, first, second, back", "Materials/al/Yield stress": "345 MPa"}
        for name, entries in {"ball": {"Shape": "sphere", "Diameter": "3.2 mm", "Velocity": "0 km/s, 6580 m/s"},
                              "first": {"Shape": "plate", "Front face": "0 cm", "Thickness": "0.01 cm"},
                              "second": {"Shape": "plate", "Front face": "2 cm", "Thickness": "0.02 cm"},
                              "back": {"Shape": "plate", "Front face": "5.01 cm", "Thickness": "0.1 cm"}}.items():
            for key, value in {"Material": "al", "Density": "2.7 g/cm^3", **entries}.items():
                values[f"Bodies/{name}/{key}"] = value
        diameter, density, velocity, shield, bumpers = limit.shot_of(values)
        self.assertAlmostEqual(diameter, 0.32)
        self.assertAlmostEqual(velocity, 6.58)
        self.assertAlmostEqual(density, 2.7)
        self.assertEqual(bumpers, 2)
        self.assertAlmostEqual(shield.bumper, 0.03)
        self.assertAlmostEqual(shield.standoff, 5.0)
        self.assertAlmostEqual(shield.wall_yield, 50.04, delta=0.01)
        del values["Materials/al/Yield stress"]
        with self.assertRaises(Unknown):
            limit.shot_of(values)


if __name__ == "__main__":
    unittest.main()
