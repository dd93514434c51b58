#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html as headless Chromium shows it: every picture loads, nothing is on the console, nothing is fetched, the picture of the
page is not empty. Skipped (77) where there is no Chromium; ./whipple test --all installs it."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "scripts"), str(ROOT / "tests/scripts")]
from report import of_run, of_study  # noqa: E402
import whipple  # noqa: E402
from written_run import write_run, write_study  # noqa: E402

# Put into a copy of the page: what has loaded, and what has asked for the network.
COUNT = """<script>addEventListener("load", () => {
  const all = [...document.images];
  document.title = `PICTURES ${all.length} LOADED ${all.filter(i => i.complete && i.naturalWidth > 0).length} FETCHED ` +
    performance.getEntriesByType("resource").filter(e => !e.name.startsWith("data:")).length;
});</script>"""


def chromium(*arguments):
    done = subprocess.run([shutil.which("chromium"), "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                           "--enable-logging=stderr", "--window-size=1300,4000", *arguments], capture_output=True, text=True, timeout=120,
                          check=True)
    assert "CONSOLE" not in done.stderr, done.stderr
    return done.stdout


def check(name, text, folder):
    page = folder / f"{name}.html"
    page.write_text(text.replace("</body>", COUNT + "</body>"), encoding="utf-8")
    title = re.search(r"<title>(.*?)</title>", chromium("--dump-dom", page.as_uri()))[1]
    count, loaded, fetched = map(int, re.fullmatch(r"PICTURES (\d+) LOADED (\d+) FETCHED (\d+)", title).groups())
    assert count == loaded > 3 and fetched == 0, f"{name}: {title}"
    picture = folder / f"{name}.png"
    chromium(f"--screenshot={picture}", page.as_uri())
    image = Image.open(picture).convert("RGB")
    colours = len(image.getcolors(maxcolors=2**24))
    assert image.size == (1300, 4000) and colours > 500, f"{name}: {image.size}, {colours} colours"
    lowest = image.crop((0, 2000, 1300, 4000)).convert("L").getextrema()
    assert lowest[1] - lowest[0] > 100, f"{name}: nothing on the second screen"
    print(f"{name}: {title}, {colours} colours")


def main():
    if not shutil.which("chromium"):
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check("run", of_run.page(whipple.open(write_run(folder / "a run"))), folder)
        check("study", of_study.page(whipple.open(write_study(folder / "a study"))), folder)


if __name__ == "__main__":
    main()
