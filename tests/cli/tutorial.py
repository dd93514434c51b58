#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run every command of doc/tutorial.md, in order, and compare what is shown there with what comes out.

    tests/cli/tutorial.py PROGRAM SOURCE

Blocks of the page by the first word behind the fence:

sh                  commands, run by sh in a scratch folder. ./whipple is a stand-in for the launcher that does not build.
sh status 2         the same, with the exit status that they must have
prm FILE            a new file; or, where FILE is there, the sections that replace those of the same name in it
python FILE         a new file
text                what the sh block before it must have shown: lines in this order, others may stand between them

In a line of text "..." stands for anything. Words must agree; numbers to 5 % or to the last digit shown. Not
compared are times, memory and cell steps of a run. In a table of a study order, limit and error bar, which come from differences,
are compared to 50 %.
"""
import pathlib
import re
import shutil
import subprocess
import sys

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?")
OF_THE_MACHINE = re.compile(r"\s*(?:s|min|ms|MB|million cell steps|rank)\b")
NOT_RUN = {"git clone ADDRESS whipple", "cd whipple"}  # the test stands in what they make

LAUNCHER = """#!/bin/sh
set -eu
drawn() {{ if [ -f "$1/study.json" ]; then echo plot_study.py; else echo plot_run.py; fi; }}
case $1 in
  build) test -x '{program}' ;;
  run) exec '{program}' "$@" ;;
  study)
    '{program}' "$@"
    name=output/$(basename "$2" .prm)
    /usr/bin/python3 '{source}/scripts/plot_study.py' "$name"
    /usr/bin/python3 '{source}/scripts/write_report.py' "$name" ;;
  plot) shift; exec /usr/bin/python3 "{source}/scripts/$(drawn "$1")" "$@" ;;
  report) shift; exec /usr/bin/python3 '{source}/scripts/write_report.py' "$@" ;;
  *) echo "the stand-in does not know: $*" >&2; exit 1 ;;
esac
"""


def blocks(page):
    """(words behind the fence, text, line number) of each fenced block."""
    found, words, lines, start = [], None, [], 0
    for number, line in enumerate(page.splitlines(), 1):
        if line.startswith("```"):
            if words is None:
                words, lines, start = line[3:].split(), [], number
            else:
                found.append((words, "\n".join(lines) + "\n", start))
                words = None
        elif words is not None:
            lines.append(line)
    assert words is None, "a block is not closed"
    return found


def put(file, text):
    """Write a file, or replace sections of one that is there."""
    if not file.exists() or file.suffix != ".prm":
        file.write_text(text)
        return
    scene = file.read_text()
    for section in re.finditer(r"^subsection (.+)\n(?:.*\n)*?end\n", text, re.M):
        scene, count = re.subn(r"^subsection %s\n(?:.*\n)*?end\n" % re.escape(section[1]), lambda _: section[0], scene, flags=re.M)
        assert count == 1, f"{file.name} has section {section[1]} {count} times"
    file.write_text(scene)


def pieces(line):
    """Words of a line, and (number, digits after the point, compared or not)."""
    words, numbers, end = [], [], 0
    for match in NUMBER.finditer(line):
        words.append(line[end:match.start()])
        end = match.end()
        mantissa, _, power = match[0].partition("e")
        last = 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))
        numbers.append((float(match[0]), last, not OF_THE_MACHINE.match(line[end:])))
    return words + [line[end:]], numbers


def close(shown, found):
    (a, last, compared), (b, _, _) = shown, found
    return not compared or abs(a - b) <= max(0.05 * abs(a), 0.51 * last)


def same(shown, found):
    """Whether a line of the page fits one of the output."""
    if shown.startswith("| ") and "error bar" not in shown:
        return same_row(shown, found)
    shown, found = " ".join(shown.split()), " ".join(found.split())
    if "..." in shown:  # each part must be found, one behind the other
        parts = [part for part in shown.split("...") if part.strip()]
        pattern = ".*".join("".join(re.escape(p) if i % 2 == 0 else f"({NUMBER.pattern})" for i, p in
                                    enumerate(re.split(f"({NUMBER.pattern})", part))) for part in parts)
        match = re.match(pattern, found)
        if not match:
            return False
        numbers = [n for part in parts for n in pieces(part)[1]]
        return all(close(a, (float(b), 0, True)) for a, b in zip(numbers, match.groups()))
    words, numbers = pieces(shown)
    other_words, other_numbers = pieces(found)
    return words == other_words and all(map(close, numbers, other_numbers))


def same_row(shown, found):
    """A row of results of a study: values to 5 %, order, limit and error bar to 50 %, the kind of convergence."""
    shown, found = ([cell.strip() for cell in line.strip().strip("|").split("|")] for line in (shown, found))
    if len(shown) != len(found) or shown[0] != found[0] or shown[-1] != found[-1]:
        return False
    for place, (a, b) in enumerate(zip(shown[1:-1], found[1:-1])):
        if bool(NUMBER.search(a)) != bool(NUMBER.search(b)):
            return False
        if NUMBER.search(a):
            x, y = float(NUMBER.search(a)[0]), float(NUMBER.search(b)[0])
            if abs(x - y) > (0.5 if place >= len(shown) - 5 else 0.05) * abs(x):
                return False
    return True


def compare(text, output, where):
    lines = iter(output.splitlines())
    for shown in text.splitlines():
        if not any(same(shown, line) for line in lines):
            near = [line for line in output.splitlines() if line.split()[:1] == shown.split()[:1]]
            sys.exit(f"doc/tutorial.md:{where}: not shown (in this order):\n{shown}\nbut:\n" + "\n".join(near or [output]))


def main():
    program, source = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    scratch = pathlib.Path("tutorial_scratch").resolve()
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir()
    for folder in ("prm", "python"):
        (scratch / folder).symlink_to(source / folder)
    launcher = scratch / "whipple"
    launcher.write_text(LAUNCHER.format(program=program, source=source))
    launcher.chmod(0o755)

    output, commands, compared = None, 0, 0
    for words, text, where in blocks((source / "doc/tutorial.md").read_text(encoding="utf-8")):
        if words[0] == "sh":
            lines = [line for line in text.splitlines() if line not in NOT_RUN]
            expected = int(words[2]) if len(words) > 2 else 0
            done = subprocess.run(["sh", "-eu", "-c", "\n".join(lines)], cwd=scratch, text=True, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, timeout=400)
            output = done.stdout
            if done.returncode != expected:
                sys.exit(f"doc/tutorial.md:{where}: status {done.returncode}, not {expected}:\n{text}\n{output}")
            commands += len(lines)
        elif words[0] in ("prm", "python"):
            put(scratch / words[1], text)
        elif words[0] == "text":
            compare(text, output, where)
            compared += len(text.splitlines())
        else:
            sys.exit(f"doc/tutorial.md:{where}: a block of kind {words}")
    pictures = sorted(file.name for file in (scratch / "output/my_shield/pictures").iterdir())
    for wanted in ("fields-", "radiograph-", "ballistic_limit"):
        assert any(name.startswith(wanted) for name in pictures), f"no {wanted} in {pictures}"
    for name in ("my_shield", "my_study"):
        assert (scratch / "output" / name / "report.html").stat().st_size > 10000, f"no report of {name}"
    assert commands >= 14 and compared >= 20, f"only {commands} commands and {compared} lines on the page"
    shutil.rmtree(scratch)
    print(f"{commands} commands run, {compared} lines compared")


if __name__ == "__main__":
    main()
