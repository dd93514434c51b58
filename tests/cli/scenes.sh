# SPDX-License-Identifier: LGPL-2.1-or-later
# The scenes to start from, on coarse cells, come out as their heads say: close to an impedance match, a test, a correlation.
# own_shield.prm is run by the tutorial; all are validated in validate.sh.
program=$1
source=$2
rm -rf output

# runs NAME SETTING...
runs() {
  name=$1
  shift
  for setting; do
    set -- "$@" --set "$setting"
    shift
  done
  "$program" run "$source/prm/$name.prm" --set 'Output/Fields interval = none' "$@" >out.txt || { cat out.txt; exit 1; }
  grep -q '"status": "completed"' "output/$name/summary.json" || { tail -n 5 out.txt; exit 1; }
}

runs plate_impact
runs taylor_bar 'Mesh/Finest cell = 0.024 cm'
runs thick_target 'Mesh/Finest cell = 0.032 cm'
runs other_materials 'Mesh/Finest cell = 0.032 cm'
runs gauges 'Mesh/Finest cell = 0.02 cm'
runs debris_cloud 'Mesh/Finest cell = 0.016 cm' 'Mesh/Levels = 3'
runs micrometeoroid 'Mesh/Finest cell = 20 um' 'Mesh/Levels = 2'
runs convergence 'Mesh/Finest cell = 0.02 cm'
runs oblique_impact

/usr/bin/python3 - <<'P'
import csv, json

def results(name):
    return json.load(open(f"output/{name}/summary.json"))["results"]

def gauge(name, which):
    rows = list(csv.DictReader(open(f"output/{name}/gauges/{which}.csv")))
    return {key: [float(row[key]) for row in rows] for key in rows[0]}

def at(table, key, time):
    return next(value for t, value in zip(table["time [us]"], table[key]) if t >= time)

def holds(what, found, reference, part):
    print(f"{what}: {found:.4g}, {reference:.4g} to {100 * part:g} %")
    assert abs(found - reference) <= part * abs(reference), what

# copper on aluminium at 0.1 cm/us: the velocity at which both Hugoniots have one pressure, by bisection
low, high = 0.0, 0.1
for _ in range(60):
    u = (low + high) / 2
    aluminium = 2.703 * (0.524 + 1.4 * u) * u
    copper = 8.93 * (0.394 + 1.489 * (0.1 - u)) * (0.1 - u)
    low, high = (u, high) if aluminium < copper else (low, u)
behind = gauge("plate_impact", "gauge")
holds("plate impact, pressure, Mbar", at(behind, "pressure [Mbar]", 0.6), aluminium, 0.015)  # strength carries 1 %
holds("plate impact, velocity, cm/us", at(behind, "velocity 1 [cm/us]", 0.6), u, 0.005)
surface = gauge("plate_impact", "free surface")
holds("plate impact, free surface, cm/us", at(surface, "velocity 1 [cm/us]", 1.2), 2 * u, 0.01)
dip = min(v for t, v in zip(surface["time [us]"], surface["velocity 1 [cm/us]"]) if 1.2 < t < 2)
holds("plate impact, pull-back, cm/us", at(surface, "velocity 1 [cm/us]", 1.2) - dip, 0.0117, 0.15)

holds("Taylor bar, length", gauge("taylor_bar", "rear face")["position 1 [cm]"][-1] / 2.347, 0.630, 0.02)  # measured

def penetration(d, velocity, density=2.703, hardness=95, target=2.703):
    power = 2 / 3 if density / target >= 1.5 else 1 / 2
    return 5.24 * d ** (19 / 18) * hardness**-0.25 * (density / target) ** power * (velocity / 5.1) ** (2 / 3)

holds("crater, cm", results("thick_target")["target"]["crater_depth_cm"], penetration(0.32, 7), 0.2)
holds("crater of steel, cm", results("other_materials")["target"]["crater_depth_cm"], penetration(0.2, 5, 7.9), 0.2)

for which in ("depth 0.5 cm", "depth 1 cm"):
    seen = gauge("gauges", which)
    pressure = max(p for p in seen["pressure [Mbar]"] if p == p)
    u = seen["velocity 1 [cm/us]"][seen["pressure [Mbar]"].index(pressure)]
    holds(f"shock at {which}, Mbar", pressure, 2.703 * (0.524 + 1.4 * u) * u, 0.1)

def hole(d, t, velocity):
    return d * (2.4 * velocity / 5.1 * (t / d) ** (2 / 3) + 0.9)

cloud = results("debris_cloud")
holds("hole below the cloud, cm", cloud["bumper"]["hole_diameter_cm"], hole(0.5, 0.05, 6.7), 0.15)
holds("front of the cloud, cm/us", cloud["cloud"]["leading_edge_velocity_cm_per_us"], 0.650, 0.03)
holds("the sphere's material, cm/us", cloud["cloud"]["inline_mass_velocity_cm_per_us"], 0.67 / (1 + 1.5 * 0.05 / 0.5), 0.08)
holds("convergence, hole, cm", results("convergence")["bumper"]["hole_diameter_cm"], 0.8646, 0.03)
holds("convergence, hole by correlation, cm", results("convergence")["bumper"]["hole_diameter_cm"], hole(0.4, 0.1, 7), 0.15)
assert results("micrometeoroid")["sheet"]["perforated"]  # far below the ballistic limit of 1.8 times the depth
holds("micrometeoroid, hole, cm", results("micrometeoroid")["sheet"]["hole_diameter_cm"], 0.0717, 0.1)
P
rm -r output
