# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a study."""
import os

import plot_study

from . import of_run
from .page import Page, escape, folded, number, picture_file, preformatted, table, with_error

PLOTS = {"work_precision": "Error against wall time: which setting to use at which accuracy",
         "convergence": "Error against cell size, with slopes of order 1 and 2", "cost": "Wall time, cell-steps and memory against cell size"}


def value_of(point, quantity):
    if quantity.get("exact"):
        return (point["errors"] or {}).get(quantity["place"], {}).get(quantity["name"]) if "errors" in point.entry else None
    return point["results"].get(quantity["place"], {}).get(quantity["name"])


def headlines(study):
    """The main results of each series: on its finest cells, with their error bar, limit and order."""
    text = ""
    for quantity in study.content["headlines"]:
        if quantity["exact"]:
            continue
        rows = []
        estimates = study.estimates(quantity["place"], quantity["name"])
        for series in study.content["series"]:
            finest = min((study.points[label] for label in series["points"]), key=lambda point: point.cell_cm)
            estimate = estimates.get(series["label"], {})
            bar, value = estimate.get("error_bar"), value_of(finest, quantity)
            rows.append([series["label"], finest.cell_cm, with_error(value, bar), estimate.get("extrapolated"), estimate.get("order"),
                         estimate.get("verdict", "")])
        text += f"<h3>{escape(quantity['readable'])}</h3>\n" + table(
            ["series", "finest cell, cm", "value", "limit", "order", "convergence"], rows)
    return text


def all_results(study):
    """Every result of every series, folded."""
    rows = []
    for series in study.content["series"]:
        for result in series["results"]:
            estimate, quantity = result["estimate"] or {}, result["quantity"]
            rows.append([series["label"], quantity["readable"], *(number(v) for v in result["values"][-1:]), estimate.get("error_bar"),
                         estimate.get("order"), estimate.get("verdict", "")])
    return folded("All results on the finest cells", table(["series", "result", "value", "error bar", "order", "convergence"], rows)) if rows else ""


def verdicts(study):
    """Yes or no, on each mesh."""
    rows = [[series["label"], verdict["place"], verdict["name"].replace("_", " "),
             ", ".join(f"{level['cell_cm']:g} cm: {number(level['value'])}" for level in verdict["levels"])]
            for series in study.content["series"] for verdict in series.get("verdicts", [])]
    return "<h3>Yes or no</h3>\n" + table(["series", "place", "what", "on cells of"], rows) if rows else ""


def points(study):
    axes = list(study.axes)
    rows = [[*(point.choices.get(axis, "") for axis in axes), point.status, point["wall_s"], point["active_cell_steps"],
             point["peak_rss_bytes"] / 1e6 if point["peak_rss_bytes"] else None,
             *(value_of(point, quantity) for quantity in study.content["headlines"]), point["reason"] or ""] for point in study.points.values()]
    return table([*axes, "status", "wall, s", "cell-steps", "memory, MB", *(q["readable"] for q in study.content["headlines"]), "reason"], rows)


def choices(study):
    """What each choice beside the mesh changes."""
    rows = [[c["axis"], c["label"], c["base"], c["quantity"]["readable"], c["cell_cm"], c["base_value"], c["value"], c["mesh_error"]]
            for c in study.content.get("choices", []) if c["quantity"] in study.content["headlines"]]
    return table(["axis", "choice", "base", "result", "cell, cm", "with the base", "with the choice", "left open by the mesh"], rows) if rows else ""


def plots(study):
    paths = [(os.path.join(study.directory, f"{name}.svg"), words) for name, words in PLOTS.items()]
    written = os.path.getmtime(os.path.join(study.directory, "study.json"))
    if not all(os.path.exists(path) and os.path.getmtime(path) >= written for path, _ in paths):
        for _ in plot_study.draw(study, study.directory):
            pass
    return "".join(picture_file(path, words) for path, words in paths if os.path.exists(path))


def finest_run(study):
    """The run on the finest cells with the base of all other axes, or what is nearest to that; None if no run has completed."""
    def distance(label):
        point = study.points[label]
        return point.cell_cm, sum(point.choices.get(name) != axis["base"] for name, axis in study.axes.items() if not axis["is_cell_axis"])

    done = [label for label in study.runs if study.points[label].status == "completed"]
    return study.runs[min(done, key=distance)] if done else None


def axes_table(study):
    return table(["axis", "parameters", "values", "base"], [[name, "; ".join(axis["parameters"]), ", ".join(axis["labels"]), axis["base"]]
                                                            for name, axis in study.axes.items()])


def errors_of_points(study):
    """Of scenes with an exact solution."""
    rows = []
    for point in study.points.values():
        for field, norms in (point.entry.get("errors") or {}).items():
            if isinstance(norms, dict):
                rows.append([point.label, field, *(norms.get(norm) for norm in ("L1", "L2", "Linf"))])
    return "<h3>Errors against the exact solution</h3>\n" + table(["point", "field", "L1", "L2", "Linf"], rows) if rows else ""


def page(study):
    """All of it as text. Errors: whipple.Damaged."""
    content = study.content
    done = sum(point.status == "completed" for point in study.points.values())
    where = f"{escape(content.get('program', ''))}; {escape(os.path.abspath(study.directory))}"
    made = Page(study.title, f'<p>A study of {len(study.points)} points, {done} completed. <span class="soft">{where}</span></p>\n'
                             f"<p><code>{escape(content.get('command', ''))}</code></p>\n")
    made.add("results", "Results", headlines(study) + errors_of_points(study) + verdicts(study) + all_results(study))
    made.add("plots", "Error and cost", plots(study))
    made.add("choices", "Choices beside the mesh", choices(study))
    made.add("points", "Points", axes_table(study) + points(study))
    run = finest_run(study)
    if run:
        finest = f"<p>Of the run on the finest cells, <code>{escape(run.directory)}</code>.</p>\n"
        made.add("pictures", "Pictures", finest + of_run.pictures(run) if run.snapshots_or_none else "")
        made.add("history", "History", finest + of_run.curve_section(run))
        made.add("effects", "Effects", finest + of_run.effects(run))
        made.add("cost", "Cost of a run", finest + of_run.cost(run))
        made.add("parameters", "Parameters", finest + of_run.parameters(run))
    path = os.path.join(study.directory, "study.md")
    if os.path.exists(path):
        with open(path, encoding="utf-8", errors="replace") as file:
            made.add("tables", "study.md", folded("The tables of study.md", preformatted(file.read())))
    return made.text()
