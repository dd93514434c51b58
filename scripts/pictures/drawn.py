# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what is not drawn yet, on all cores, and says how far it is.

FOLDER/.drawn.json remembers of each picture what it was made of: the files of the run, the options, the programs that draw. A
picture for which that is the same is left as it is.
"""
import functools
import glob
import hashlib
import json
import multiprocessing
import os
import re
import signal
import sys
import time
from dataclasses import dataclass


@dataclass(frozen=True)
class Job:
    """A picture: draw(*arguments, path) makes FOLDER/file; made_of: what it depends on beside the scripts."""

    file: str
    draw: object
    arguments: tuple
    made_of: tuple


def state_of(path):
    """Changes when a file does."""
    try:
        status = os.stat(path)
    except FileNotFoundError:
        return None
    return path, status.st_size, status.st_mtime_ns


@functools.lru_cache(maxsize=None)
def version_of_scripts():
    """Of everything here and of the package."""
    here = os.path.dirname(os.path.abspath(__file__))
    whole = hashlib.sha1()
    for path in sorted(glob.glob(os.path.join(here, "*.py")) + glob.glob(os.path.join(here, "../../python/whipple/*.py"))):
        with open(path, "rb") as file:
            whole.update(file.read())
    return whole.hexdigest()


def key_of(job):
    return hashlib.sha1(repr((version_of_scripts(), job.made_of)).encode()).hexdigest()


def read_book(folder):
    try:
        with open(os.path.join(folder, ".drawn.json"), encoding="utf-8") as file:
            book = json.load(file)
            return book if isinstance(book, dict) else {}
    except (OSError, ValueError):
        return {}


def write_book(folder, book):
    with open(os.path.join(folder, ".drawn.json"), "w", encoding="utf-8") as file:
        json.dump(book, file, indent=0, sort_keys=True)


JOBS = []  # of this process and those it forks: what they hold need not be sent


def leave_interrupts():
    """Ctrl-C is for the process that waits."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def draw_job(number):
    folder, job = JOBS[number]
    try:
        job.draw(*job.arguments, os.path.join(folder, job.file))
    except Exception as error:  # what is wrong is said where all is said
        return number, error
    return number, None


class Progress:
    """One line that is written over, on a terminal; elsewhere the paths as they come."""

    def __init__(self, count):
        self.count, self.done, self.start = count, 0, time.monotonic()

    def step(self, path):
        self.done += 1
        if not sys.stdout.isatty():
            print(path, flush=True)
            return
        left = (time.monotonic() - self.start) / self.done * (self.count - self.done)
        print(f"\r{self.done} of {self.count} pictures, {left:.0f} s left ", end="\n" if self.done == self.count else "", flush=True)


def draw_all(jobs, folder, again=False):
    """Draw jobs that are new, or all of them. Returns the paths of all, in their order. Errors: those of the drawing."""
    os.makedirs(folder, exist_ok=True)
    book = read_book(folder)
    new = [job for job in jobs if again or book.get(job.file) != key_of(job) or not os.path.exists(os.path.join(folder, job.file))]
    progress = Progress(len(new))
    JOBS[:] = [(folder, job) for job in new]
    processes = min(len(os.sched_getaffinity(0)), len(new))
    try:
        if processes > 1:
            with multiprocessing.get_context("fork").Pool(processes, initializer=leave_interrupts) as pool:
                finish(pool.imap_unordered(draw_job, range(len(new))), new, folder, book, progress)
        else:
            finish(map(draw_job, range(len(new))), new, folder, book, progress)
    finally:
        JOBS.clear()
        write_book(folder, book)
    return [os.path.join(folder, job.file) for job in jobs], len(new)


def remove_stale(folder, count):
    """Pictures that we drew of an earlier run in this directory, of written times from number COUNT on, which this run has not."""
    book = read_book(folder)
    for file in list(book):
        numbered = re.search(r"-(\d{5})\.(png|svg)$", file)
        if numbered and int(numbered[1]) >= count:
            del book[file]
            if os.path.exists(os.path.join(folder, file)):
                os.remove(os.path.join(folder, file))
    if book:
        write_book(folder, book)


def finish(results, jobs, folder, book, progress):
    for number, error in results:
        if error:
            raise error
        job = jobs[number]
        book[job.file] = key_of(job)
        progress.step(os.path.join(folder, job.file))
