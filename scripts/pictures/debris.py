# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the lists in summary.json: debris of each gap by angle and velocity, load on the last plate by radius.
Needs python3-matplotlib."""
import matplotlib.pyplot as plt

from whipple import NotWritten


def steps(axes, edges, values, label=None):
    axes.stairs(values, edges, label=label, linewidth=1.4)
    axes.grid(alpha=0.3)


def debris(gaps, path):
    """Share of mass, axial momentum and kinetic energy in each bin, a row a gap."""
    figure, panels = plt.subplots(len(gaps), 2, figsize=(11, 1.2 + 2.4 * len(gaps)), squeeze=False, sharex="col",
                                  layout="constrained")
    for (name, table), (left, right) in zip(gaps.items(), panels):
        for axes, by, edges in ((left, "angle", table["angle_edges_deg"]),
                                (right, "velocity", [10.0 * v for v in table["velocity_edges_cm_per_us"]])):
            for words, quantity, unit in (("mass", "mass", "g"), ("axial momentum", "axial_momentum", "g_cm_per_us"),
                                          ("kinetic energy", "kinetic_energy", "Mbar_cm3")):
                values = table[f"{quantity}_by_{by}_{unit}"]
                all_of_it = sum(values) or 1.0
                steps(axes, edges, [value / all_of_it for value in values], words)
        left.set(title=f"{name}, {table['time_us']:.2f} us", ylabel="share in the bin", xlim=(0.0, 90.0))
        right.set(title=f"{table['mass_g']:.3g} g, {10.0 * table['mass_velocity_cm_per_us']:.2f} km/s in the mean")
    panels[0][0].legend(fontsize=8)
    panels[-1][0].set_xlabel("angle from the line of flight, degrees")
    panels[-1][1].set_xlabel("axial velocity, km/s")
    figure.savefig(path, dpi=120)
    plt.close(figure)


def load(name, table, path):
    by = "radius" if "load_by_radius_edges_cm" in table else "place"
    edges = table[f"load_by_{by}_edges_cm"]
    figure, panels = plt.subplots(1, 3, figsize=(13, 3.8), layout="constrained")
    for axes, quantity, words in zip(panels, (f"landed_mass_by_{by}_g_per_cm2", f"impulse_by_{by}_Mbar_us",
                                              f"delivered_energy_by_{by}_Mbar_cm"),
                                     ("mass, g/cm$^2$", "impulse, Mbar us", "energy, Mbar cm")):
        steps(axes, edges, table[quantity])
        axes.set(ylabel=words, xlabel="radius, cm" if by == "radius" else "x, cm")
    figure.suptitle(f"{name}: {table['landed_mass_g']:.3g} g, {table['impulse_g_cm_per_us']:.3g} g cm/us, "
                        f"{table['delivered_energy_Mbar_cm3']:.3g} Mbar cm$^3$")
    figure.savefig(path, dpi=120)
    plt.close(figure)


def pictures(run):
    """[(file name, what draws it, its arguments)]. Errors: whipple.NotWritten if there is nothing to draw."""
    results = run.results
    gaps = {stage["name"]: results[stage["name"]] for stage in run.summary["stages"]
            if "angle_edges_deg" in results.get(stage["name"], {}) and "mass_by_angle_g" in results[stage["name"]]}
    plates = {name: table for name, table in results.items() if "impulse_g_cm_per_us" in table}
    if not gaps and not plates:
        raise NotWritten(f"{run.directory}: summary.json has no debris and no load on a plate")
    jobs = [("debris", debris, (gaps,))] if gaps else []
    return jobs + [(f"load-{name}", load, (name, table)) for name, table in plates.items()]
