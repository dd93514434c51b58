# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of one written time: the panel, an overview of the whole scene, the plate enlarged, what has been measured.

All pictures of a run are of one size and one scale.
"""
import functools

import matplotlib.pyplot as plt
from matplotlib.cm import ScalarMappable
from matplotlib.patches import Rectangle
from matplotlib.ticker import FuncFormatter

from . import marks
from .panel import show
from .quantities import told_apart
from .windows import Window

DPI = 120
TOP, BOTTOM = 0.62, 0.62  # inches
PANEL = 5.5
BESIDE = 2.15  # for overview and enlarged plate
OVERVIEW = 2.3
BAR = 1.05


class Layout:
    """A figure with axes at places given in inches. Axes, ticks and bars stay from one picture to the next: making them costs more than
    all that changes."""

    def __init__(self, panels, scales, bodies, beside):
        self.left = 0.75 + (BESIDE if beside else 0.0)
        bars = self.left + panels * PANEL + (panels - 1) * 0.75
        self.width, self.height = bars + len(scales) * BAR + 0.15, TOP + PANEL + BOTTOM
        self.figure = plt.figure(figsize=(self.width, self.height))
        self.panels = [self.axes(self.left + number * (PANEL + 0.75), BOTTOM, PANEL, PANEL) for number in range(panels)]
        self.overview = self.axes(0.15, BOTTOM + PANEL - OVERVIEW, 1.75, OVERVIEW) if beside else None
        self.enlarged = self.axes(0.4, BOTTOM, 1.5, 1.5) if beside else None
        for number, scale in enumerate(scales):
            words = "" if len(scales) == 1 or panels > 1 else ("right half", "left half")[number]
            colour_bar(self.axes(bars + 0.24 + number * BAR, BOTTOM + 0.1 * PANEL, 0.16, 0.8 * PANEL), scale, words)
        if bodies and beside:
            height = min(0.2 * len(bodies), 1.3)
            marks.body_key(self.axes(0.25, BOTTOM + PANEL - OVERVIEW - 0.15 - height, 1.7, height), bodies)

    def place(self, left, bottom, width, height):
        return left / self.width, bottom / self.height, width / self.width, height / self.height

    def axes(self, *inches):
        return self.figure.add_axes(self.place(*inches))

    def text(self, left, below_top, words, **how):
        self.figure.text(left / self.width, 1.0 - below_top / self.height, words, va="center", **how)

    def wipe(self):
        """Take away what belongs to one picture."""
        for axes in (*self.panels, self.overview, self.enlarged):
            for artist in [*axes.images, *axes.lines, *axes.patches, *axes.texts] if axes else []:
                artist.remove()
        for text in list(self.figure.texts):
            text.remove()


@functools.lru_cache(maxsize=2)
def layout_of(panels, scales, bodies, beside):
    return Layout(panels, scales, bodies, beside)


def cleared_layout(run, snapshot, panels, names, scales, beside):
    layout = layout_of(panels, tuple(scales[name] for name in dict.fromkeys(names) if name != "bodies"),
                       tuple(run.bodies) if "bodies" in names and told_apart(run, snapshot) else (), beside)
    layout.wipe()
    return layout


def colour_bar(axes, scale, words):
    bar = axes.figure.colorbar(ScalarMappable(scale.norm(), scale.colour_map()), cax=axes)
    axes.set_ylim(*scale.shown())
    bar.minorticks_off()
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    bar.set_label(scale.quantity.label, fontsize=9, labelpad=2)
    axes.tick_params(labelsize=8)
    if words:
        axes.set_title(words, fontsize=8, pad=4)


def overview(layout, run, snapshot, window, scene, names, scales):
    """The whole scene, small, with the window; plates are lines where they are not, or not yet."""
    across = scene.x_max - scene.x_min if run.is_planar else 2.0 * scene.x_max
    scale = min(1.75 / across, OVERVIEW / (scene.z_max - scene.z_min))
    width, height = across * scale, (scene.z_max - scene.z_min) * scale
    axes = layout.overview
    axes.set_position(layout.place(0.15 + 0.5 * (1.75 - width), BOTTOM + PANEL - height, width, height))
    pixels = max(2 * int(0.5 * width * DPI), 2), max(int(height * DPI), 2)
    show(axes, run, snapshot, scene, names, scales, pixels)
    axes.set(xlabel="", ylabel="", xticks=[], yticks=[])
    for plate in run.plates:
        axes.add_patch(Rectangle((-scene.x_max, plate.front), 2.0 * scene.x_max, plate.thickness, fill=False, edgecolor="0.45", linewidth=0.4))
    left = window.x_min if run.is_planar else -window.x_max
    axes.add_patch(Rectangle((left, window.z_min), window.x_max - left, window.z_max - window.z_min, fill=False, linewidth=0.9,
                             edgecolor="k"))
    axes.set_title("whole scene", fontsize=8, pad=3)


def enlarged(layout, run, snapshot, window, names, scales):
    """Of a thin plate in the panel the part at the axis; not where the panel shows it well enough."""
    size, axes = window.z_max - window.z_min, layout.enlarged
    thin = [plate for plate in run.plates if window.holds(plate.front) and plate.thickness < 0.05 * size
            and marks.is_there(snapshot, run, plate)]
    axes.set_visible(bool(thin) and not run.is_planar)
    if not axes.get_visible():
        return
    plate = thin[-1]
    half = min(max(2.2 * plate.thickness, 0.08 * size), 0.3 * size)
    middle = plate.front + 0.5 * plate.thickness
    close = Window(0.0, half, middle - half, middle + half)
    show(axes, run, snapshot, close, names, scales, (2 * int(0.75 * DPI), int(1.5 * DPI)))
    result = marks.measured(run, snapshot).get(plate.name)
    if result:
        marks.hole_and_crater(axes, plate, result, close)
    axes.set(xlabel="", ylabel="")
    axes.tick_params(labelsize=7)
    axes.set_title(f"{plate.name}, enlarged", fontsize=8, pad=3)


def time_words(run, snapshot):
    return f"t = {snapshot.time - run.contact_time:.3f} us{' after contact' if run.contact_time > 0.0 or run.plates else ''}"


def head(layout, run, snapshot):
    """Title, time and stage; below what has been measured."""
    layout.text(layout.left, 0.14, run.title, fontsize=8.5, color="0.3")
    layout.text(layout.left, 0.39, time_words(run, snapshot), fontsize=13, weight="bold")
    layout.text(layout.left + PANEL, 0.39, f"stage {snapshot.stage}", fontsize=11, ha="right")
    words = [marks.words_of(name, result) for name, result in marks.measured(run, snapshot).items()]
    layout.text(layout.left, layout.height - 0.12, ";  ".join(words), fontsize=9)


def names_by_panel(planar, names):
    """[(right, left)] for each panel: planar scenes have a panel for each quantity."""
    return [(name, name) for name in reversed(names)] if planar else [(names[0], names[-1])]


def save(figure, path):
    how = {"pil_kwargs": {"compress_level": 3}} if path.endswith("png") else {}
    figure.savefig(path, dpi=DPI, **how)


def panel(axes, run, snapshot, window, pair, scales, first):
    show(axes, run, snapshot, window, pair, scales, (int(PANEL * DPI), int(PANEL * DPI)))
    marks.mark(axes, run, snapshot, window)
    if not first:
        axes.set_ylabel("")


def frame(run, snapshot, window, scene, names, scales, path):
    """Draw one. names: of the right half and of the left half (planar: of the right and the left panel). scene: Window of the
    overview."""
    pairs = names_by_panel(run.is_planar, names)
    layout = cleared_layout(run, snapshot, len(pairs), names, scales, True)
    for number, pair in enumerate(pairs):
        panel(layout.panels[number], run, snapshot, window, pair, scales, number == 0)
    overview(layout, run, snapshot, window, scene, pairs[-1], scales)
    enlarged(layout, run, snapshot, window, pairs[-1], scales)
    head(layout, run, snapshot)
    save(layout.figure, path)
    snapshot.forget()


def side_by_side(pairs, window, names, scales, path):
    """Two runs: pairs [(run, snapshot, words)], the same window and scale."""
    layout = cleared_layout(*pairs[0][:2], len(pairs), names, scales, False)
    for number, (run, snapshot, words) in enumerate(pairs):
        axes = layout.panels[number]
        panel(axes, run, snapshot, window, names, scales, number == 0)
        results = "; ".join(marks.words_of(*item) for item in marks.measured(run, snapshot).items())
        left = layout.left + number * (PANEL + 0.75)
        layout.text(left, 0.16, words, fontsize=11, weight="bold")
        layout.text(left, 0.42, f"{time_words(run, snapshot)}, stage {snapshot.stage}", fontsize=10)
        layout.text(left, layout.height - 0.12, results, fontsize=9)
        snapshot.forget()
    save(layout.figure, path)
