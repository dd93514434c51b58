# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that pages are made of, kept from one making of a page to the next. Standard library only."""
import os
import subprocess

import run_record

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


class NoResult(SystemExit):
    """A run neither completed nor stopped in order; the text is what it said."""


def kept_run(build, directory, scene, settings):
    """Summary of a scene of the repository with settings ("Section/Key = value"), run if DIRECTORY holds no completed one.

    build: build directory. Errors: NoResult."""
    summary = run_record.summary(directory)
    if summary is None or summary["status"] != "completed":
        command = [os.path.abspath(os.path.join(build, "whipple")), "run", os.path.join(ROOT, scene), "--output", directory]
        for setting in settings:
            command += ["--set", setting]
        result = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        summary = run_record.summary(directory)
        if result.returncode not in (0, 3) or summary is None:
            raise NoResult(f"{directory}: {result.stderr.strip()}")
    return summary
