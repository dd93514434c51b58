#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of small runs and of a small study: well-formed, every section there, every picture embedded and readable, nothing
fetched from elsewhere, what the user wrote escaped."""
import base64
import contextlib
import html.parser
import io
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
from report import of_run, of_study, page  # noqa: E402
import whipple  # noqa: E402
from written_run import write_run, write_study  # noqa: E402

EMPTY = {"meta", "link", "img"}


class Reader(html.parser.HTMLParser):
    """Checks that tags close in order, and collects what matters."""

    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.open, self.ids, self.pictures, self.addresses, self.text, self.titles = [], [], [], [], "", []

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag not in EMPTY:
            self.open.append(tag)
        if "id" in attributes:
            self.ids.append(attributes["id"])
        self.addresses += [attributes[name] for name in ("src", "href", "srcset", "action", "data") if name in attributes]
        if tag == "img":
            self.pictures.append((attributes["src"], attributes["alt"]))

    def handle_startendtag(self, tag, attributes):
        assert tag in EMPTY, tag
        self.handle_starttag(tag, attributes)

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, f"</{tag}> closes {self.open[-3:]}"
        self.open.pop()

    def handle_data(self, data):
        self.text += data
        if self.open and self.open[-1] == "h2":
            self.titles.append(data)


class Report(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def read(self, text):
        """Everything that holds for every page."""
        reader = Reader()
        reader.feed(text)
        reader.close()
        self.assertEqual(reader.open, [])
        ElementTree.fromstring(text.removeprefix("<!DOCTYPE html>\n"))  # it is XML too
        self.assertEqual(len(reader.ids), len(set(reader.ids)))
        for address in reader.addresses:
            self.assertTrue(address.startswith("data:") or address[0] == "#" and address[1:] in reader.ids, address[:60])
        self.assertNotRegex(text, r"url\(|@import|<script")
        for source, words in reader.pictures:
            self.assertTrue(words)
            kind, data = re.fullmatch(r"data:image/(png|svg\+xml);base64,(.+)", source).groups()
            content = base64.b64decode(data, validate=True)
            if kind == "png":
                image = Image.open(io.BytesIO(content)).convert("L")
                self.assertGreater(image.getextrema()[1] - image.getextrema()[0], 100)
            else:
                self.assertTrue(ElementTree.fromstring(content).tag.endswith("svg"))
        return reader

    def page_of(self, directory):
        with contextlib.redirect_stdout(io.StringIO()):
            what = whipple.open(directory)
            return self.read((of_study if isinstance(what, whipple.Study) else of_run).page(what))

    def test_run(self):
        bars = {"bumper": {"hole_diameter_cm": {"error": 0.061, "order": 1.0, "extrapolated": 1.2, "verdict": "monotone"}}}
        performance = {"wall_s": 1.0, "cpu_s": 0.8, "peak_rss_bytes": 1e8, "ranks": 1, "phases": {"remap": 0.3, "lagrange step": 0.6}}
        write_run(self.path / "run", error_bars=bars, performance=performance)
        (self.path / "run/history.csv").write_text("time_us,bumper hole_diameter_cm\n0,0\n1,1\n2,1.25\n")
        found = self.page_of(self.path / "run")
        self.assertEqual(found.titles, ["Results", "Pictures", "History", "Stages", "Ledger", "Effects", "Cost", "Parameters", "Log"])
        captions = " ".join(words for _, words in found.pictures)
        for words in ("hit, ", "flight, ", "end of each stage", "statistics.csv", "bumper: results against time", "gauge behind"):
            self.assertIn(words, captions)
        for words in ("bumper: hole 1.250 ± 0.061 cm", "monotone", "wall: holds", "not debris", "too cold", "slivers locked", "lagrange step",
                      "sound 90 %", "Mesh/Finest cell", "0.1 cm", "warning: <the log>"):
            self.assertIn(words, found.text)
        self.assertNotIn("Without error bars", found.text)

    def test_run_without_fields_error_bars_or_history(self):
        found = self.page_of(write_run(self.path / "bare", fields=False))
        self.assertIn("set Output/Fields interval", found.text)
        self.assertIn("Without error bars", found.text)
        self.assertNotIn("By phase", found.text)
        self.assertNotIn("results against time", str(found.pictures))

    def test_run_that_goes_on_or_was_stopped(self):
        write_run(self.path / "run")
        (self.path / "run/summary.json").unlink()
        (self.path / "run/statistics.csv").unlink()
        found = self.page_of(self.path / "run")
        self.assertIn("has not ended", found.text)
        self.assertEqual(found.titles, ["Results", "Pictures", "History", "Parameters", "Log"])
        write_run(self.path / "stopped", status="stopped", reason="an element <folded> & more")
        self.assertIn("stopped early: an element <folded> & more", self.page_of(self.path / "stopped").text)

    def test_title_is_escaped(self):
        directory = write_run(self.path / "run", fields=False)
        path = directory / "parameters.prm"
        path.write_text(path.read_text().replace("A small shield", "a < b & \"c\" <script>"))
        self.assertIn('a < b & "c" <script>', self.page_of(directory).text)

    def test_study(self):
        found = self.page_of(write_study(self.path / "study"))
        self.assertEqual(found.titles, ["Results", "Error and cost", "Points", "Pictures", "History", "Effects", "Cost of a run", "Parameters",
                                        "study.md"])
        for words in ("bumper hole diameter, cm", "1.10 ± 0.45", "two levels", "points/cell=0.25cm"):
            self.assertIn(words, found.text)
        self.assertGreaterEqual(len(found.pictures), 5)

    def test_numbers(self):
        for value, error, text in ((0.65279, 0.0613, "0.653 ± 0.061"), (33.63, 4.0, "33.6 ± 4.0"), (0.0, 0.0, "0 ± 0"), (1.5, None, "1.5"),
                                   (True, 0.1, "yes"), (None, 0.1, "–"), (2.01e-5, 1.1e-5, "2.01e-05 ± 1.1e-05"), (18234.0, 1500.0, "18234 ± 1500")):
            self.assertEqual(page.with_error(value, error), text)

    def test_command(self):
        command = [sys.executable, str(ROOT / "scripts/write_report.py")]
        done = subprocess.run([*command, str(write_run(self.path / "run", fields=False))], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.strip(), str(self.path / "run/report.html"))
        self.read((self.path / "run/report.html").read_text(encoding="utf-8"))
        (self.path / "bad").mkdir()
        (self.path / "bad/study.json").write_text(json.dumps({}))
        for directory, words in ((self.path / "nowhere", "there is no such directory"), (self.path, "neither the output of a run"),
                                 (self.path / "bad", "study.json: has no 'study'")):
            done = subprocess.run([*command, str(directory)], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
