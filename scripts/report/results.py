# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of a run: a card a place, and all of them in tables."""
from whipple.units import readable

from .page import escape, folded, number, table, with_error

FIRST = ("perforated", "perforation_margin_cm", "hole_diameter_cm", "crater_depth_cm", "mass_g", "mass_velocity_cm_per_us",
         "leading_edge_velocity_cm_per_us", "cone_angle_deg")


def shown(value, bar):
    return with_error(value, (bar or {}).get("error"))


def plate_card(name, result, bars, is_wall):
    """Of the wall, which is to hold, with a colour."""
    hole, crater, margin = (shown(result.get(key), bars.get(key)) for key in ("hole_diameter_cm", "crater_depth_cm", "perforation_margin_cm"))
    if result["perforated"] is None:
        return "", f"{escape(name)}: not measured", "the plate cannot be seen on this mesh"
    if result["perforated"]:
        return "bad" if is_wall else "", f"{escape(name)}: hole {hole} cm", f"perforated, by a margin of {margin} cm"
    return "good" if is_wall else "", f"{escape(name)}: holds", f"crater {crater} cm, margin {margin} cm"


def gap_card(name, result, bars):
    parts = []
    for key, words, factor, unit in (("mass_velocity_cm_per_us", "mean", 10.0, "km/s"), ("leading_edge_velocity_cm_per_us", "front", 10.0, "km/s"),
                                     ("cone_angle_deg", "cone", 1.0, "°")):
        if result.get(key) is not None:
            parts.append(f"{words} {number(result[key] * factor, 3)} {unit}")
    return "", f"{escape(name)}: {shown(result['mass_g'], bars.get('mass_g'))} g of debris", ", ".join(parts)


def cards(run):
    """What a shield designer asks first."""
    made = []
    plates = [name for name, result in run.results.items() if "perforated" in result]
    for name, result in run.results.items():
        bars = run.error_bars.get(name, {})
        if name in plates:
            side, big, small = plate_card(name, result, bars, name == plates[-1] and len(plates) > 1)
        elif result.get("mass_g") is not None and "mass_velocity_cm_per_us" in result:
            side, big, small = gap_card(name, result, bars)
        else:
            continue
        made.append(f'<div class="card {side}"><b>{big}</b><span>{small}</span></div>')
    return f'<div class="cards">{"".join(made)}</div>\n' if made else ""


def rows_of(result, bars):
    keys = [key for key in FIRST if key in result] + [key for key in result if key not in FIRST]
    for key in keys:
        value, bar = result[key], bars.get(key) or {}
        if isinstance(value, (list, dict)):
            continue
        words, unit = readable(key)
        yield [words, shown(value, bar), unit, bar.get("verdict", "")]


def one_table(result, bars):
    rows = list(rows_of(result, bars))
    if not bars:
        return table(["result", "value", "unit"], [row[:3] for row in rows])
    return table(["result", "value", "unit", "convergence"], rows)


def lists(run):
    """Those by bins, for who wants the numbers."""
    text = ""
    for name, result in run.results.items():
        binned = {key: values for key, values in result.items() if isinstance(values, list)}
        for key, values in binned.items():
            words, unit = readable(key)
            text += f"<p><b>{escape(name)}, {escape(words)}{escape(', ' + unit if unit else '')}:</b> {', '.join(number(v) for v in values)}</p>\n"
    return folded("Lists by angle, velocity, size and radius", text) if text else ""


def section(run):
    if not run.summary_or_none:
        return "<p>The run has not ended: it has no results yet.</p>\n"
    text = cards(run)
    if not run.error_bars:
        text += ("<p>Without error bars: results of one mesh. <code>--set 'Output/Error estimate = 3'</code> runs coarser ones as "
                 "well and says how far each result may be from its limit.</p>\n")
    places = "".join(f"<div><h3>{escape(name)}</h3>\n{one_table(result, run.error_bars.get(name, {}))}</div>\n"
                     for name, result in run.results.items())
    text += f'<div class="places">\n{places}</div>\n'
    if run.summary.get("errors"):
        text += "<h3>Errors against the exact solution</h3>\n" + table(
            ["field", "L1", "L2", "Linf", "scale"], [[name, *(e.get(k) for k in ("L1", "L2", "Linf", "scale"))]
                                                     for name, e in run.summary["errors"].items()])
    return text + lists(run)
