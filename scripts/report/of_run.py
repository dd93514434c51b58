# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of a run."""
import os

from pictures import ballistic_limit, debris, figures, of_times
from pictures.drawn import draw_all
from whipple import NotWritten, WhippleError
from whipple.units import readable

from . import curves, results
from .page import Html, Page, escape, folded, number, picture_file, preformatted, table

MOST_PICTURES = 14


def below_title(run):
    """Status, versions, where it lies."""
    summary = run.summary_or_none
    if not summary:
        return '<p>This run <b>has not ended</b>; the page shows what is there so far.</p>\n'
    program = summary.get("program", {})
    words = {"completed": "completed", "stopped": "<b>stopped early</b>"}.get(summary["status"], escape(summary["status"]))
    reason = f": {escape(summary['reason'])}" if summary.get("reason") else ""
    cost = summary.get("performance", {})
    return (f"<p>The run {words}{reason}. {number(cost.get('wall_s'), 3)} s on {number(cost.get('ranks'))} rank(s). "
            f'<span class="soft">Scene {escape(summary.get("scene", ""))}, Whipple {escape(program.get("version", ""))} '
            f'({escape(program.get("commit", ""))}, {escape(program.get("build_type", ""))}); {escape(os.path.abspath(run.directory))}</span></p>\n')


def chosen_times(run):
    """The first, and of each stage the last and one from the middle; of chains of many stages only the ends."""
    stages = run.stages()
    middles = [group[len(group) // 2] for _, group in stages if len(group) > 2] if 2 * len(stages) < MOST_PICTURES else []
    ends = [group[-1] for _, group in stages]
    return sorted({s.number: s for s in [run.snapshots[0], *middles, *ends]}.values(), key=lambda s: s.number)


def pictures(run):
    """Written times, all stages, debris, load and limit, as far as the run has them."""
    folder, shown = run.path("pictures"), []
    text = ""
    if run.snapshots_or_none:
        times = of_times.Times(run, ("density", "bodies"))
        snapshots = chosen_times(run)
        paths, _ = draw_all([times.frame(snapshot, "png") for snapshot in snapshots], folder)
        text += '<div class="grid">\n' + "".join(
            picture_file(path, f"{s.stage}, {s.time - run.contact_time:.3f} us after contact: bodies and density")
            for path, s in zip(paths, snapshots)) + "</div>\n"
        if len(run.stages()) > 1:
            shown.append(("strip", figures.strip, (run,), "The end of each stage, by axial velocity"))
    else:
        text += f"<p>{escape(run.directory)} has no fields: set Output/Fields interval in the scene, and there are pictures.</p>\n"
    try:
        shown += [(name, draw, arguments, "Debris by angle and velocity" if name == "debris" else "Load on the last plate by radius")
                  for name, draw, arguments in (debris.pictures(run) if run.summary_or_none else [])]
    except NotWritten:
        pass
    shown.append(("ballistic_limit", ballistic_limit.picture, (run,), "This shot and tests beside the ballistic limit of the shield"))
    os.makedirs(folder, exist_ok=True)
    for name, draw, arguments, words in shown:
        path = os.path.join(folder, f"{name}.png")
        try:
            draw(*arguments, path)
        except WhippleError:
            continue  # not such a shield
        text += picture_file(path, words)
    return text


def stages(run):
    """What each stage was, how it ended, what ruled its time steps."""
    rows = []
    for stage in run.summary["stages"]:
        asked = run.parameters.get(f"Stages/{stage['name']}/End", "")
        limits = sorted(stage.get("dt_limits", {}).items(), key=lambda pair: -pair[1])
        ruled = ", ".join(f"{name} {100.0 * count / max(stage['steps'], 1):.0f} %" for name, count in limits[:3])
        rows.append([stage["name"], stage["mode"], asked, stage["start_us"], stage["end_us"], stage["steps"], stage.get("active_cells_max"),
                     stage.get("elements"), stage.get("dropped_mass_g"), ruled])
    text = table(["stage", "mode", "ends", "from, us", "to, us", "steps", "most cells", "elements", "dropped, g", "time step ruled by"], rows)
    counts = run.summary.get("counts", {})
    events = counts.get("events", {})
    if events:
        text += "<h3>What the scheme had to do to go on</h3>\n" + table(
            ["what", "times", "in all", "unit"], [[name, e.get("number"), e.get("size"), e.get("unit", "")] for name, e in events.items()])
    plain = {name: value for name, value in counts.items() if name != "events"}
    text += "<p>" + ", ".join(f"{escape(name)}: {number(value)}" for name, value in plain.items()) + "</p>\n" if plain else ""
    warnings = [line for line in run.log.splitlines() if line.startswith("warning:")]
    return text + (f"<h3>Warnings</h3>\n{preformatted(chr(10).join(warnings))}" if warnings else "")


def title_of(key):
    """'mass, g' of 'mass_g'."""
    words, unit = readable(key)
    return f"{words}, {unit}" if unit else words


def dropped_words(entry):
    return {f"dropped: {what}": amount for what, amount in (entry.get("dropped") or {}).items()}


def ledger(run):
    """Everything that entered, left and is there; then what kinetic energy turned into."""
    books = run.summary.get("ledger")
    if not books:
        return ""
    columns = [name for name in ("mass_g", "axial_momentum_g_cm_per_us", "energy_Mbar_cm3") if name in books]
    lines = {name: {"introduced": books[name].get("initial"), "left the domain": books[name].get("left_domain"), **dropped_words(books[name]),
                    "present at the end": books[name].get("final"), "closes to (relative)": books[name].get("closure_relative")}
             for name in columns}
    order = list(dict.fromkeys(line for name in columns for line in lines[name] if line not in ("present at the end", "closes to (relative)")))
    order += ["present at the end", "closes to (relative)"]
    titles = {"mass_g": "mass, g", "axial_momentum_g_cm_per_us": "axial momentum, g cm/us", "energy_Mbar_cm3": "energy, Mbar cm³"}
    text = table(["", *(titles[name] for name in columns)], [[line, *(lines[name].get(line) for name in columns)] for line in order])
    energy = {key: value for key, value in books.get("energy_Mbar_cm3", {}).items()
              if key not in ("initial", "final", "left_domain", "dropped", "closure_relative")}
    if energy:
        whole = abs(books["energy_Mbar_cm3"].get("initial") or 0.0)
        text += "<h3>Energy: parts and what turned into heat</h3>\n" + table(
            ["what", "Mbar cm³", "% of what was introduced"],
            [[key.replace("_", " "), value, 100.0 * value / whole if whole and value is not None else None] for key, value in energy.items()])
    bodies = books.get("bodies") or {}
    if bodies:
        keys = list(dict.fromkeys(key for body in bodies.values() for key in body))
        text += "<h3>Bodies at the end</h3>\n" + table(["body", *map(title_of, keys)],
                                                       [[name, *(body.get(key) for key in keys)] for name, body in bodies.items()])
    return text


def effects(run):
    rows = [[name, Html("<b>on</b>" if e.get("on") else "off"), e.get("number"), e.get("reason", "")]
            for name, e in (run.summary.get("effects") or {}).items()]
    return table(["effect", "", "chosen by", "why"], rows) if rows else ""


def phases(entry):
    """Of performance/phases: name -> seconds, or name -> {what: number}; biggest first. Nothing without them."""
    if not entry:
        return ""
    if all(isinstance(value, dict) for value in entry.values()):
        keys = list(dict.fromkeys(key for value in entry.values() for key in value))
        return table(["phase", *map(title_of, keys)],
                     [[name, *(value.get(key) for key in keys)] for name, value in entry.items()])
    whole = sum(value for value in entry.values() if isinstance(value, (int, float))) or 1.0
    ordered = sorted(entry.items(), key=lambda pair: -(pair[1] or 0.0))
    return table(["phase", "s", "%"], [[name, value, 100.0 * (value or 0.0) / whole] for name, value in ordered])


def cost(run):
    """By stage, and by phase where the run says so."""
    performance = run.summary.get("performance", {})
    whole = performance.get("wall_s") or 0.0
    rows = [[s["name"], s.get("wall_s"), 100.0 * s["wall_s"] / whole if whole else None, s.get("cpu_s"), s.get("steps"), s.get("cell_steps"),
             s.get("cell_steps_per_s_per_rank")] for s in run.summary["stages"]]
    text = table(["stage", "wall, s", "% of the run", "cpu, s", "steps", "cell-steps", "cell-steps/s/rank"], rows)
    memory = performance.get("peak_rss_bytes")
    text += (f"<p>In all {number(whole)} s on the clock, {number(performance.get('cpu_s'))} s of processors, "
             f"{number(memory / 1e6 if memory else None, 3)} MB at most, {number(performance.get('ranks'))} rank(s).</p>\n")
    shown = phases(performance.get("phases"))
    return text + (f"<h3>By phase</h3>\n{shown}" if shown else "")


def parameters(run):
    """Those that are not the defaults; all of them folded."""
    differing = table(["parameter", "value", "default"], [[name, value, default or Html('<span class="soft">none</span>')]
                                                          for name, value, default in run.parameters.differing()])
    with open(run.path("parameters.prm"), encoding="utf-8", errors="replace") as file:
        everything = preformatted(file.read())
    return f"<h3>Not as the defaults</h3>\n{differing}" + folded("All parameters (parameters.prm, a scene that runs again)", everything)


def curve_section(run):
    try:
        text = curves.statistics(run)
    except NotWritten:
        text = ""
    return curves.results(run) + text + curves.gauges(run)


def page(run):
    """All of it as text. Errors: whipple.Damaged."""
    made = Page(run.title, below_title(run))
    made.add("results", "Results", results.section(run))
    made.add("pictures", "Pictures", pictures(run))
    made.add("history", "History", curve_section(run))
    if run.summary_or_none:
        made.add("stages", "Stages", stages(run))
        made.add("ledger", "Ledger", ledger(run))
        made.add("effects", "Effects", effects(run))
        made.add("cost", "Cost", cost(run))
    made.add("parameters", "Parameters", parameters(run))
    if run.log:
        made.add("log", "Log", folded("log.txt", preformatted(run.log)))
    return made.text()
