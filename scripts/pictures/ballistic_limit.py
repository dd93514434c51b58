# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ballistic limit of a Whipple shield [Christiansen1993]: the largest sphere that the wall withstands (no perforation, no
detached spall), against its velocity. Lengths in cm, densities in g/cm^3, velocities in km/s, yield stress of the wall in ksi.

With V_n = V cos(theta), theta at most 65 degrees,

    V_n <= 3      d_c = [(t_w (sigma/40)^0.5 + t_b) / (0.6 cos(theta)^(5/3) rho_p^0.5 V^(2/3))]^(18/19)
    V_n >= 7      d_c = 3.918 t_w^(2/3) rho_p^(-1/3) rho_b^(-1/9) V_n^(-2/3) S^(1/3) (sigma/70)^(1/3)
    between       linear in V_n from the one at 3 to the other at 7
"""
import csv
import dataclasses
import math
import os

import matplotlib.pyplot as plt
import numpy as np

from whipple import Unknown
from whipple.scene import bodies, plates
from whipple.units import quantity

TESTS = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "data", "whipple_shots.csv")
MPA_OF_KSI = 6.894757
LOW, HIGH = 3.0, 7.0  # km/s


@dataclasses.dataclass
class Shield:
    bumper: float  # thickness, cm
    bumper_density: float
    standoff: float  # from bumper to wall, cm
    wall: float  # thickness, cm
    wall_yield: float  # ksi

    def critical_diameter(self, velocity, density, angle=0.0):
        """Of a sphere of this density (g/cm^3), cm."""
        cosine = math.cos(math.radians(min(angle, 65.0)))
        normal = velocity * cosine

        def slow(v_n):
            return ((self.wall * (self.wall_yield / 40.0)**0.5 + self.bumper)
                    / (0.6 * cosine**(5.0 / 3.0) * density**0.5 * (v_n / cosine)**(2.0 / 3.0)))**(18.0 / 19.0)

        def fast(v_n):
            return (3.918 * self.wall**(2.0 / 3.0) * density**(-1.0 / 3.0) * self.bumper_density**(-1.0 / 9.0)
                    * v_n**(-2.0 / 3.0) * self.standoff**(1.0 / 3.0) * (self.wall_yield / 70.0)**(1.0 / 3.0))

        if normal <= LOW:
            return slow(normal)
        if normal >= HIGH:
            return fast(normal)
        part = (normal - LOW) / (HIGH - LOW)
        return (1.0 - part) * slow(LOW) + part * fast(HIGH)


@dataclasses.dataclass
class Test:
    name: str
    diameter: float
    density: float
    velocity: float
    shield: Shield
    perforated: bool

    def is_near(self, shield):
        """A shield whose parts are within a third, its standoff within a half, of another's."""
        def near(a, b, ratio):
            return max(a, b) <= ratio * min(a, b)

        s = self.shield
        return (near(s.bumper, shield.bumper, 4.0 / 3.0) and near(s.wall, shield.wall, 4.0 / 3.0)
                and near(s.standoff, shield.standoff, 1.5) and near(s.bumper_density, shield.bumper_density, 1.1))

    def excess(self):
        """Its diameter over what the shield it was shot at withstands."""
        return self.diameter / self.shield.critical_diameter(self.velocity, self.density)


def normal_aluminium_tests(path=TESTS):
    """Those of the table whose sphere and bumper are of aluminium, normal impact."""
    with open(path, newline="", encoding="utf8") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        next(rows)  # units
        for row in rows:
            try:
                density, bumper_density = float(row["proj_density"]), float(row["bumper_density"])
                test = Test(row["shotID"], float(row["proj_diam"]), density, float(row["velocity"]),
                            Shield(float(row["bumper_thick"]), bumper_density, float(row["standoff"]),
                                   float(row["wall_thick"]), float(row["wall_yield"])), row["result"] == "P")
            except ValueError:
                continue
            if float(row["angle"]) == 0 and 2.5 < density < 3.0 and 2.5 < bumper_density < 3.0:
                yield test


def shot_of(values):
    """Diameter, density and velocity of the sphere, and the shield, of a run's parameters; and how many bumpers there are. Several
    bumpers count as one of their mass at the first one's place."""
    all_bodies, found = bodies(values), plates(values)
    spheres = [body for body in all_bodies.values() if body["Shape"] == "sphere"]
    if len(spheres) != 1 or len(found) < 2:
        raise Unknown("the ballistic limit is that of a sphere on a bumper and a wall")
    velocity = quantity(spheres[0]["Velocity"].split(",")[1], "km/s")
    *bumpers, wall = found
    wall_yield = values.get(f"Materials/{all_bodies[wall.name]['Material']}/Yield stress", "")
    if not wall_yield:
        raise Unknown("the wall's material has no entry 'Yield stress', which the limit depends on")
    densities = [quantity(all_bodies[plate.name]["Density"], "g/cm^3") for plate in bumpers]
    mass = sum(density * plate.thickness for density, plate in zip(densities, bumpers))
    density = densities[0]
    standoff = wall.front - bumpers[0].rear
    shield = Shield(mass / density, density, standoff, wall.thickness, quantity(wall_yield, "MPa") / MPA_OF_KSI)
    return quantity(spheres[0]["Diameter"], "cm"), quantity(spheres[0]["Density"], "g/cm^3"), velocity, shield, len(bumpers)


def scatter(axes, tests, height):
    for perforated, colour, words in ((True, "tab:red", "test: perforated"), (False, "tab:blue", "test: held")):
        of_kind = [t for t in tests if t.perforated == perforated]
        axes.scatter([t.velocity for t in of_kind], [height(t) for t in of_kind], s=24, facecolors=colour if perforated else
                     "none", edgecolors=colour, label=f"{words} ({len(of_kind)})", zorder=3)


def picture(run, path):
    """Left: the curve of this shield with the tests of shields like it; right: all tests, each over the limit of its own shield.
    Errors: whipple.Unknown."""
    diameter, density, velocity, shield, bumpers = shot_of(run.parameters)
    result = (run.summary_or_none or {}).get("results", {}).get(run.plates[-1].name, {})
    perforated = result.get("perforated")
    words = {True: "perforated", False: "held"}.get(perforated, "not decided")
    tests = list(normal_aluminium_tests())
    near = [t for t in tests if t.is_near(shield)]

    figure, (left, right) = plt.subplots(1, 2, figsize=(13, 5.5), layout="constrained")
    speeds = np.linspace(1.0, 10.0, 400)
    left.plot(speeds, [shield.critical_diameter(v, density) for v in speeds], "k", label="limit [Christiansen 1993]")
    scatter(left, near, lambda t: t.diameter)
    style = {"marker": "*", "s": 220, "facecolors": "gold" if perforated is not False else "none", "edgecolors": "k", "zorder": 4}
    left.scatter([velocity], [diameter], label=f"this run: {words}", **style)
    for test in near:
        left.annotate(test.name, (test.velocity, test.diameter), fontsize=6, xytext=(3, 3), textcoords="offset points")
    what = "bumper" if bumpers == 1 else f"{bumpers} bumpers as one"
    left.set(xlim=(0.0, 10.0), ylim=(0.0, 1.3 * max([diameter, shield.critical_diameter(LOW, density),
                                                     *(t.diameter for t in near)])),
             xlabel="velocity, km/s", ylabel="diameter of the sphere, cm")
    left.set_title(f"{what} {shield.bumper:.3g} cm, standoff {shield.standoff:.4g} cm, wall {shield.wall:.3g} cm, "
                   f"{shield.wall_yield:.0f} ksi", fontsize=10)
    left.legend(fontsize=8)

    scatter(right, tests, Test.excess)
    right.scatter([velocity], [diameter / shield.critical_diameter(velocity, density)], label=f"this run: {words}", **style)
    right.axhline(1.0, color="k", linewidth=1)
    right.set(xlim=(0.0, 10.0), ylim=(0.25, 6.0), yscale="log", xlabel="velocity, km/s",
              ylabel="diameter / limit of the shield it was shot at")
    right.set_title("normal aluminium tests, all shields", fontsize=10)
    right.legend(fontsize=8)
    figure.savefig(path, dpi=130)
    plt.close(figure)
