# SPDX-License-Identifier: LGPL-2.1-or-later
"""HTML by hand: sections, tables, embedded pictures."""
import base64
import html
import io
import math

import matplotlib.pyplot as plt

STYLE = """
:root { color-scheme: light; --line: #d8d5cc; --soft: #f5f3ee; --strong: #1d3557; --good: #1b7f4d; --bad: #b3261e; }
* { box-sizing: border-box; }
body { margin: 0; font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; color: #23262b; background: #fff; }
header, main, nav { max-width: 1180px; margin: 0 auto; padding: 0 24px; }
header { padding-top: 28px; }
h1 { font-size: 26px; margin: 0 0 4px; color: var(--strong); }
h2 { font-size: 20px; margin: 38px 0 10px; padding-bottom: 4px; border-bottom: 2px solid var(--strong); color: var(--strong); }
h3 { font-size: 16px; margin: 22px 0 6px; }
p { margin: 6px 0 10px; max-width: 80ch; }
nav { position: sticky; top: 0; background: #fffffff2; border-bottom: 1px solid var(--line); padding-top: 8px; padding-bottom: 8px; z-index: 2; }
nav { display: flex; flex-wrap: wrap; } nav a { margin-right: 16px; color: var(--strong); text-decoration: none; white-space: nowrap; }
nav a:hover { text-decoration: underline; }
.soft { color: #666a72; }
.cards { display: flex; flex-wrap: wrap; gap: 14px; margin: 14px 0; }
.card { border: 1px solid var(--line); border-left: 5px solid #8a8f98; border-radius: 4px; padding: 10px 16px; background: var(--soft); min-width: 200px; }
.card b { display: block; font-size: 17px; } .card.good { border-left-color: var(--good); } .card.bad { border-left-color: var(--bad); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: 6px 0 14px; font-size: 14px; }
th, td { padding: 3px 12px 3px 8px; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
th { background: var(--soft); font-weight: 600; } td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
figure { margin: 12px 0; } figcaption { color: #666a72; font-size: 13px; }
img { max-width: 100%; height: auto; border: 1px solid var(--line); }
.places { display: flex; flex-wrap: wrap; gap: 6px 34px; align-items: flex-start; }
.grid { display: grid; grid-template-columns: repeat(auto-fit, minmax(480px, 1fr)); gap: 14px; } .grid figure { margin: 0; }
pre { background: var(--soft); border: 1px solid var(--line); padding: 10px; overflow-x: auto; font-size: 12.5px; line-height: 1.35; }
details { margin: 10px 0; } summary { cursor: pointer; color: var(--strong); font-weight: 600; }
footer { max-width: 1180px; margin: 40px auto 24px; padding: 0 24px; color: #666a72; font-size: 13px; }
@media print { nav { display: none; } h2 { break-after: avoid; } figure, table { break-inside: avoid; } }
"""


def escape(words):
    return html.escape(str(words), quote=True)


def number(value, digits=4):
    """A value as it is read: yes and no, four digits, a dash for what is not known."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (int, float)):
        if not math.isfinite(value):
            return "–"
        if value == int(value) and abs(value) < 1e7:
            return f"{int(value):,}".replace(",", "\u202f")
        return f"{value:.{digits}g}"
    return escape(value)


def with_error(value, error):
    """0.645 ± 0.012: as many decimals as the error has, which has two digits."""
    if error is None or value is None or isinstance(value, bool) or not math.isfinite(error):
        return Html(number(value))
    if error == 0.0 or value == 0.0 or not 1e-4 <= abs(value) < 1e6:
        return Html(f"{number(value)} ± {number(error, 2)}")
    decimals = max(1 - math.floor(math.log10(error)), 0)
    return Html(f"{value:.{min(decimals, 7)}f} ± {error:.{min(decimals, 7)}f}")


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def table(head, rows):
    """HEAD: titles. ROWS: lists of values or of Html. A column of numbers only stands to the right."""
    rows = [list(row) for row in rows]
    right = [bool(rows) and all(row[i] is None or is_number(row[i]) for row in rows) for i in range(len(head))]

    def cells(row, tag):
        return "".join(f'<{tag}{" class=number" if side else ""}>{value if isinstance(value, Html) else number(value)}</{tag}>'
                       for value, side in zip(row, right))

    head_cells = cells([Html(escape(title)) for title in head], "th").replace("class=number", 'class="number"')
    body = "".join(f"<tr>{cells(row, 'td')}</tr>\n" for row in rows).replace("class=number", 'class="number"')
    return f'<div class="scroll"><table>\n<thead><tr>{head_cells}</tr></thead>\n<tbody>\n{body}</tbody></table></div>\n'


class Html(str):
    """Text that is HTML already."""


def embedded(content, kind, words):
    """A picture in the page: kind png or svg+xml."""
    data = base64.b64encode(content).decode()
    return f'<figure><img src="data:image/{kind};base64,{data}" alt="{escape(words)}"/><figcaption>{escape(words)}</figcaption></figure>\n'


def picture_file(path, words):
    with open(path, "rb") as file:
        return embedded(file.read(), "svg+xml" if path.endswith(".svg") else "png", words)


def drawn(figure, words):
    """A figure of matplotlib, in lines that stay sharp."""
    file = io.BytesIO()
    figure.savefig(file, format="svg")
    plt.close(figure)
    return embedded(file.getvalue(), "svg+xml", words)


def folded(title, content):
    return f"<details><summary>{escape(title)}</summary>\n{content}</details>\n"


def preformatted(text):
    return f"<pre>{escape(text)}</pre>\n"


class Page:
    """Sections in their order, then the whole page."""

    def __init__(self, title, below):
        self.title, self.below, self.sections = title, below, []

    def add(self, name, title, content):
        """A section; one without content is left out."""
        if content:
            self.sections.append((name, title, content))

    def text(self):
        links = "".join(f'<a href="#{name}">{escape(title)}</a>' for name, title, _ in self.sections)
        body = "".join(f'<section id="{name}">\n<h2>{escape(title)}</h2>\n{content}</section>\n' for name, title, content in self.sections)
        return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8"/>\n'
                f'<meta name="viewport" content="width=device-width, initial-scale=1"/>\n<title>{escape(self.title)}</title>\n'
                f'<link rel="icon" href="data:,"/>\n<style>{STYLE}</style>\n</head>\n<body>\n'
                f"<header>\n<h1>{escape(self.title)}</h1>\n{self.below}</header>\n<nav>{links}</nav>\n<main>\n{body}</main>\n"
                f"<footer>Written by <code>./whipple report</code>. Units: cm, g, us, Mbar; 1 Mbar = 100 GPa, 1 Mbar cm³ = 100 kJ, "
                f"1 cm/us = 10 km/s.</footer>\n</body>\n</html>\n")
