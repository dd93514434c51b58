#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One page with everything about a run or a study, which opens anywhere, without a network: DIR/report.html.

    scripts/write_report.py DIR [--output FILE]

Needs python3-matplotlib and python3-h5py.
"""
import os
import sys

from one_line import OneLine
from report import of_run, of_study

import whipple


def main():
    parser = OneLine("report", __doc__)
    parser.add_argument("directory", help="output of a run or a study")
    parser.add_argument("--output", metavar="FILE", help="default DIR/report.html")
    arguments = parser.parse_args()
    path = arguments.output or os.path.join(arguments.directory, "report.html")
    try:
        what = whipple.open(arguments.directory)
        sys.stdout, shown = sys.stderr, sys.stdout  # pictures on the way are no result
        text = (of_study if isinstance(what, whipple.Study) else of_run).page(what)
        sys.stdout = shown
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    except (whipple.WhippleError, OSError) as error:
        print(f"report: {error}", file=sys.stderr)
        sys.exit(2)
    print(path)


if __name__ == "__main__":
    main()
