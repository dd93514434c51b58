#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check what documents and comments point to: links and paths in the pages, keys of doc/references.bib everywhere.

    scripts/check_documents.py

Looked at are the links of Markdown pages (files, and headings within them), paths in back quotes that begin with a folder of
the repository or a room (hydro/pack.h), pages of doc/ that are named in comments, and citations such as [Noh1987] in pages,
comments and scenes. One line for each that leads nowhere; exit status 1 if there is any. Standard library only.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("source", "include", "tests", "prm", "doc", "scripts", "python", "bench", "cmake")
ROOMS = [room.name for room in (ROOT / "include/whipple").iterdir() if room.is_dir() and room.name != "output"]  # output/: of runs
SHORT = re.compile(r"`((?:%s)/[\w./*-]+)`" % "|".join(ROOMS))
PAGE = re.compile(r"(?<![\w/.])doc/[\w/]+\.(?:md|bib)\b")
CITED = re.compile(r"\[((?:[A-Za-z]+(?:19|20)\d\d(?:,\s*)?)+)\]")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
INVENTED = "pressure_hardening"  # the example of doc/adding_a_model.md
PATH = re.compile(r"`((?:%s)/[\w./*-]*)`" % "|".join(FOLDERS))


def headings(page):
    """Anchors of a Markdown page, as GitHub makes them."""
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.S)
    found = set()
    for line in text.splitlines():
        if match := re.match(r"#+\s+(.*)", line):
            words = re.sub(r"[`*]|\[|\]\([^)]*\)|\]", "", match[1]).strip().lower()
            found.add(re.sub(r"[^\w\- ]", "", words).replace(" ", "-"))
    return found


def keys():
    """Keys of the bibliography, and whatever is in it twice."""
    entries = re.findall(r"^@\w+\{(\w+),", (ROOT / "doc/references.bib").read_text(encoding="utf-8"), flags=re.M)
    return set(entries), sorted({key for key in entries if entries.count(key) > 1})


def check_page(page, faults):
    text = page.read_text(encoding="utf-8")
    for target in LINK.findall(text):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, anchor = target.partition("#")
        file = page.parent / name if name else page
        if not file.exists():
            faults.append(f"{page.relative_to(ROOT)}: link to {target}: no such file")
        elif anchor and file.suffix == ".md" and anchor not in headings(file):
            faults.append(f"{page.relative_to(ROOT)}: link to {target}: no such heading")
    for path in PATH.findall(text):
        if INVENTED in path or re.search(r"\b[A-Z]{3,}\b", path):  # a placeholder such as NAME
            continue
        if not list(ROOT.glob(path.rstrip("/"))) and not list(ROOT.glob(path + ".*")):
            faults.append(f"{page.relative_to(ROOT)}: `{path}`: no such file")
    for path in SHORT.findall(text):
        if not any(list(ROOT.glob(f"{top}/{path}{end}")) for top in ("source", "include/whipple") for end in ("", ".*")):
            faults.append(f"{page.relative_to(ROOT)}: `{path}`: no such file in a room")


def main():
    faults = []
    known, twice = keys()
    faults += [f"doc/references.bib: {key} is there twice" for key in twice]
    pages = [page for pattern in ("*.md", "doc/**/*.md", "prm/**/*.md", ".github/**/*.md") for page in ROOT.glob(pattern)]
    for page in pages:
        check_page(page, faults)
    kinds = (".h", ".cc", ".prm", ".py", ".sh", ".bib", ".cmake")
    others = [file for folder in FOLDERS for file in (ROOT / folder).rglob("*") if file.suffix in kinds]
    for file in pages + others:
        text = file.read_text(encoding="utf-8")
        faults += [f"{file.relative_to(ROOT)}: {page}: no such page" for page in set(PAGE.findall(text)) if not (ROOT / page).exists()]
        for group in CITED.findall(text):
            for key in re.split(r",\s*", group):
                if key and key not in known:
                    faults.append(f"{file.relative_to(ROOT)}: [{key}] is not in doc/references.bib")
    print("\n".join(faults) if faults else f"{len(pages)} pages, {len(known)} references: all links lead somewhere")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
