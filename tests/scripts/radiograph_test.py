#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The projection of scripts/pictures/radiograph.py: a sphere, boxes by formula, and the mass of elements of any shape."""
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from pictures.radiograph import areal_density  # noqa: E402


def box(r0, r1, z0, z1):
    return [[r0, z0], [r1, z0], [r1, z1], [r0, z1]]


def volume(quads):
    """Of revolution: by Pappus, over both triangles."""
    quads = np.asarray(quads)
    total = 0.0
    for a, b, c in ((0, 1, 2), (0, 2, 3)):
        p, q, s = quads[:, a], quads[:, b], quads[:, c]
        area = 0.5 * ((q[:, 0] - p[:, 0]) * (s[:, 1] - p[:, 1]) - (s[:, 0] - p[:, 0]) * (q[:, 1] - p[:, 1]))
        total = total + 2.0 * np.pi * (p[:, 0] + q[:, 0] + s[:, 0]) / 3.0 * area
    return total


class Radiograph(unittest.TestCase):
    def test_ring_is_the_difference_of_two_chords(self):
        x_edges, z_edges = np.linspace(0.0, 1.0, 201), np.linspace(0.0, 1.0, 5)
        image = areal_density([box(0.3, 0.7, 0.25, 0.5)], [2.7], x_edges, z_edges)
        self.assertTrue(np.all(image[[0, 2, 3]] == 0.0))
        middle = 0.5 * (x_edges[1:] + x_edges[:-1])
        chord = lambda r: 2.0 * np.sqrt(np.maximum(r * r - middle * middle, 0.0))
        away = np.minimum(abs(middle - 0.3), abs(middle - 0.7)) > 0.03  # from where the chord begins
        np.testing.assert_allclose(image[1][away], 2.7 * (chord(0.7) - chord(0.3))[away], rtol=2e-3, atol=1e-14)

    def sphere_image(self, quads, density, n=40):
        edges = np.linspace(0.0, 1.25, n + 1)
        return edges, areal_density(quads, density, edges, np.linspace(-1.25, 1.25, 2 * n + 1))

    def compare_with_sphere(self, edges, image, density):
        """Within 1 % of 2 rho (R^2 - b^2)^(1/2) where b < 0.9 R; means over a pixel by 8 x 8 points."""
        n = len(edges) - 1
        step = edges[1]
        inner = (np.arange(8 * n) + 0.5) * step / 8.0
        x, z = inner[None, :], (np.arange(16 * n) + 0.5)[:, None] * step / 8.0 - 1.25
        chord = 2.0 * density * np.sqrt(np.maximum(1.0 - x * x - z * z, 0.0))
        expected = chord.reshape(2 * n, 8, n, 8).mean(axis=(1, 3))
        b = np.hypot(*np.meshgrid(edges[:-1] + 0.5 * step, np.arange(2 * n) * step - 1.25 + 0.5 * step))
        self.assertGreater((b < 0.9).sum(), 1000)
        np.testing.assert_allclose(image[b < 0.9], expected[b < 0.9], rtol=0.01)
        self.assertTrue(np.all(image[b > 1.0 + 2.0 * step] == 0.0))

    def test_sphere_of_cells_with_volume_fractions(self):
        """As a fixed mesh shows it: boxes, those on the surface partly filled."""
        h, quads, density = 0.0125, [], []
        for i in range(81):
            for j in range(-81, 81):
                r = (i + (np.arange(8) + 0.5) / 8.0)[:, None] * h
                z = (j + (np.arange(8) + 0.5) / 8.0)[None, :] * h
                fill = ((r * r + z * z < 1.0) * r).sum() / (r + 0.0 * z).sum()
                if fill > 0:
                    quads.append(box(i * h, (i + 1) * h, j * h, (j + 1) * h))
                    density.append(2.7 * fill)
        edges, image = self.sphere_image(quads, density)
        self.compare_with_sphere(edges, image, 2.7)

    def test_sphere_of_deformed_elements(self):
        """As a moving mesh shows it: elements between radii and angles, none of whose edges is along an axis."""
        quads = []
        angles, radii = np.linspace(-0.5, 0.5, 91) * np.pi, np.linspace(0.0, 1.0, 21)
        for a0, a1 in zip(angles[:-1], angles[1:]):
            for r0, r1 in zip(radii[:-1], radii[1:]):
                quads.append([[r * max(np.cos(a), 0.0), r * np.sin(a)]
                              for r, a in ((r0, a0), (r1, a0), (r1, a1), (r0, a1))])
        edges, image = self.sphere_image(quads, np.full(len(quads), 2.7))
        self.compare_with_sphere(edges, image, 2.7)
        mirrored = [quad[::-1] for quad in quads]  # clockwise
        np.testing.assert_allclose(self.sphere_image(mirrored, np.full(len(quads), 2.7))[1], image, atol=1e-12)

    def test_mass_is_exact_whatever_the_shape(self):
        random = np.random.default_rng(5)
        centre = random.uniform([0.3, -0.8], [0.8, 0.8], (500, 2))
        angle = np.sort(random.uniform(0.0, 2.0 * np.pi, (500, 4)), axis=1)
        quads = centre[:, None] + 0.2 * np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        density = random.uniform(0.1, 3.0, 500)
        x_edges, z_edges = np.linspace(0.0, 1.1, 37), np.linspace(-1.1, 1.1, 53)
        image = areal_density(quads, density, x_edges, z_edges)
        mass = 2.0 * image.sum() * (x_edges[1] - x_edges[0]) * (z_edges[1] - z_edges[0])
        self.assertAlmostEqual(mass / (density * volume(quads)).sum(), 1.0, delta=1e-12)

    def test_planar_is_the_density(self):
        image = areal_density([box(0.2, 0.6, 0.0, 1.0)], [1.5], np.linspace(0.0, 1.0, 11), [0.0, 0.5, 1.0], planar=True)
        np.testing.assert_allclose(image[0], [0.0, 0.0, 1.5, 1.5, 1.5, 1.5, 0.0, 0.0, 0.0, 0.0], atol=1e-12)


if __name__ == "__main__":
    unittest.main()
