# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that pages are made of, kept from one making of a page to the next."""
import os
import subprocess

from package import ROOT

import whipple


class NoResult(SystemExit):
    """A run neither completed nor stopped in order; the text is what it said."""


def summary_of(directory):
    """None of a directory that is no run, or of a run that has not ended."""
    try:
        return whipple.Run(directory).summary_or_none
    except whipple.NotARun:
        return None


def kept_run(build, directory, scene, settings):
    """Summary of a scene of the repository with settings ("Section/Key = value"), run if DIRECTORY holds no completed one.

    build: build directory. Errors: NoResult."""
    summary = summary_of(directory)
    if summary is None or summary["status"] != "completed":
        command = [os.path.abspath(os.path.join(build, "whipple")), "run", os.path.join(ROOT, scene), "--output", directory, "--overwrite"]
        for setting in settings:
            command += ["--set", setting]
        result = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=False)
        summary = summary_of(directory)
        if result.returncode not in (0, 3) or summary is None:
            raise NoResult(f"{directory}: {result.stderr.strip()}")
    return summary
