#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How pictures are made: which element is on which pixel, one scale for a run with white at zero, windows, marks, and that only what
is new is drawn."""
import os
import pathlib
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from pictures import drawn, frames, marks, of_times, quantities, raster, windows  # noqa: E402
import whipple  # noqa: E402
from written_run import RESULTS, write_run  # noqa: E402


def box(x0, x1, z0, z1):
    return [[x0, z0], [x1, z0], [x1, z1], [x0, z1]]


class OnPixels(unittest.TestCase):
    WINDOW = (0.0, 8.0, 0.0, 4.0)

    def test_boxes_of_different_size(self):
        image = raster.cover([box(0, 2, 0, 2), box(2, 3, 0, 1), box(6, 9, 3, 5)], self.WINDOW, (4, 8))
        np.testing.assert_array_equal(image, [[0, 0, 1, -1, -1, -1, -1, -1], [0, 0, -1, -1, -1, -1, -1, -1], [-1] * 8,
                                              [-1, -1, -1, -1, -1, -1, 2, 2]])

    def test_turned_element_has_its_area(self):
        diamond = [[4.0, 0.2], [5.8, 2.0], [4.0, 3.8], [2.2, 2.0]]
        for corners in (diamond, diamond[::-1]):  # either way round
            image = raster.cover([corners], self.WINDOW, (400, 800))
            self.assertAlmostEqual((image == 0).sum() / 100.0**2, 0.5 * 3.6**2, delta=0.01)
        self.assertEqual(image[200, 400], 0)
        self.assertEqual(image[20, 250], -1)

    def test_many_elements_tile_the_window(self):
        x = np.linspace(0.0, 8.0, 33)
        z = np.linspace(0.0, 4.0, 17)
        corners = [box(a, b, c, d) for c, d in zip(z[:-1], z[1:]) for a, b in zip(x[:-1], x[1:])]
        image = raster.cover(corners, self.WINDOW, (64, 128))
        np.testing.assert_array_equal(np.bincount(image.ravel()), 16)

    def test_small_elements_are_seen_but_cover_nothing(self):
        speck = box(5.1, 5.2, 3.1, 3.2)
        image = raster.cover([speck, box(0, 2, 0, 2), box(0.9, 0.91, 0.9, 0.91)], self.WINDOW, (4, 8))
        self.assertEqual(image[3, 5], 0)
        self.assertEqual((image == 2).sum(), 0)

    def test_cracks_close_and_gaps_do_not(self):
        image = raster.close_gaps(np.array([[-1, -1, -1, -1, -1], [-1, 0, -1, 1, -1], [-1, -1, -1, -1, 2]]))
        np.testing.assert_array_equal(image[1], [-1, 0, 0, 1, -1])
        self.assertTrue((image[0] == -1).all())

    def test_paint_blends_with_the_background(self):
        image = np.zeros((2, 4), dtype=int)
        image[:, 3] = -1
        picture = raster.paint(image, np.array([[1.0, 0.0, 0.0, 1.0]]), (0.0, 1.0, 0.0))
        np.testing.assert_allclose(picture, [[[1, 0, 0], [0.5, 0.5, 0]]])


class Colours(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.run_ = whipple.open(write_run(pathlib.Path(self.folder.name) / "run"))

    def scale(self, name):
        snapshots = self.run_.snapshots
        return quantities.scales_of([name], snapshots, lambda q: [quantities.extremes(q, s) for s in snapshots])[name]

    def test_white_is_zero(self):
        for name in ("velocity", "pressure"):
            scale = self.scale(name)
            self.assertEqual(scale.norm()(0.0), 0.5)
            np.testing.assert_allclose(scale.colour_map()(0.5)[:3], 1.0, atol=0.04)
        self.assertLess(self.scale("pressure").norm()(-1.0), 0.5)
        low, high = self.scale("velocity").shown()  # nothing flies back: the bar hardly shows it
        np.testing.assert_allclose((low, high), (-0.3, 3.0))

    def test_nothing_has_the_colour_of_the_background(self):
        for name, colours in quantities.COLOURS.items():
            distance = np.abs(colours(np.linspace(0, 1, 256))[:, :3] - quantities.BACKGROUND).max(axis=1)
            self.assertGreater(distance.min(), 0.06, name)

    def test_any_field_and_what_there_is_not(self):
        self.assertEqual(quantities.quantity_of("steel temperature", self.run_.elements()).label, "steel temperature, K")
        with self.assertRaises(whipple.Unknown):
            quantities.quantity_of("melt", self.run_.elements())
        for name in ("density", "solid", "speed", "temperature", "mesh", "steel temperature"):
            colours = self.scale(name).colours(self.run_.elements())
            self.assertEqual(colours.shape, (8, 4))
        steel = self.scale("temperature")
        self.assertEqual((steel.low, steel.high), (300.0, 700.0))

    def test_bodies_keep_their_colours(self):
        colours = quantities.paint_bodies(self.run_, self.run_.elements())
        palette = quantities.colours_of_bodies(self.run_.bodies)
        np.testing.assert_allclose(colours[0, :3], palette["ball"])
        np.testing.assert_allclose(colours[-1, :3], 0.2 * palette["bumper"] + 0.8 * palette["wall"], atol=1e-6)
        self.assertLess(colours[0, 3], colours[-1, 3])  # a tenth solid is paler

    def test_round_up(self):
        for value, above in ((0.9, 1.0), (1.2, 1.5), (7.1, 8.0), (2.785, 3.0), (5.3e-7, 6e-7), (0.0, 1.0)):
            self.assertAlmostEqual(quantities.round_up(value) / above, 1.0)


class Frames(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def test_windows(self):
        run = whipple.open(write_run(self.path / "run"))
        times = of_times.Times(run, ("density", "bodies"))
        for snapshot, window in zip(run.snapshots, times.windows):
            self.assertAlmostEqual(2.0 * window.x_max, window.z_max - window.z_min)  # square when mirrored
            self.assertTrue(window.holds(snapshot.time + 0.5) and window.holds(snapshot.time + 1.5))
        self.assertLess(times.windows[1].z_min, times.windows[2].z_min)  # it follows the debris
        planar = whipple.open(write_run(self.path / "planar", symmetry="planar"))
        window = of_times.Times(planar, ("density", "bodies")).windows[0]
        self.assertAlmostEqual(window.x_max - window.x_min, window.z_max - window.z_min)

    def test_a_stage_on_a_fixed_mesh_has_one_window(self):
        plate = whipple.scene.Plate("bumper", 0.0, 0.1)
        window = windows.of_a_fixed_mesh([(0.0, 0.1, -0.3, 0.1), (0.0, 0.4, -0.2, 0.9)], [plate], False)
        self.assertTrue(window.holds(-0.29) and window.holds(0.89))
        wide = windows.of_a_fixed_mesh([(0.0, 1.0, -20.0, 0.0)], [plate], False)  # a long cloud comes in
        self.assertGreater(wide.z_min, -3.0)
        self.assertTrue(wide.holds(0.1))

    def test_measured(self):
        run = whipple.open(write_run(self.path / "run", results={**RESULTS, "bumper": {**RESULTS["bumper"], "measured_at_us": 0.0}}))
        self.assertEqual(marks.measured(run, run.snapshots[0])["bumper"]["hole_diameter_cm"], 1.25)
        self.assertEqual(marks.measured(run, run.snapshots[1]), {})
        self.assertEqual(marks.words_of("bumper", RESULTS["bumper"]), "bumper: hole 1.25 cm")
        self.assertEqual(marks.words_of("wall", RESULTS["wall"]), "wall: holds, crater 0.1 cm, 0.4 cm left")
        (self.path / "run/history.csv").write_text("time_us,bumper hole_diameter_cm\n0,0.5\n0.9,0.75\n2,2\n")
        table = whipple.open(self.path / "run").history
        self.assertEqual(marks.at_time(table, "bumper", 1.0), {"hole_diameter_cm": 0.75})
        self.assertEqual(marks.at_time(table, "bumper", -1.0), {})

    def test_drawn_once(self):
        for symmetry in ("axisymmetric", "planar"):
            run = whipple.open(write_run(self.path / symmetry, symmetry=symmetry))
            jobs = [of_times.Times(run, ("pressure", "bodies")).frame(snapshot, "png") for snapshot in run.snapshots]
            sys.stdout, kept = open(os.devnull, "w", encoding="utf-8"), sys.stdout
            try:
                paths, new = drawn.draw_all(jobs, str(self.path / "pictures" / symmetry))
                self.assertEqual((len(paths), new), (3, 3))
                self.assertEqual(drawn.draw_all(jobs, str(self.path / "pictures" / symmetry))[1], 0)
            finally:
                sys.stdout.close()
                sys.stdout = kept
            folder = self.path / "pictures" / symmetry
            (folder / "own-00007.png").touch()  # not ours
            drawn.remove_stale(str(folder), 2)
            self.assertEqual(sorted(os.listdir(folder)), [".drawn.json", "own-00007.png", *(os.path.basename(p) for p in paths[:2])])
            paths.pop()
            sizes = {frames.plt.imread(path).shape for path in paths}
            self.assertEqual(len(sizes), 1)
            self.assertGreater(frames.plt.imread(paths[0]).std(), 0.02)


if __name__ == "__main__":
    unittest.main()
