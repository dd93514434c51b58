# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can go wrong when a run is read. The text of each error is one line that says what to do."""


class WhippleError(Exception):
    """Base of all errors of this package."""

    def __str__(self):
        return " ".join(str(part) for part in self.args)


class NotARun(WhippleError):
    """The directory is neither the output of a run nor that of a study."""


class Damaged(WhippleError):
    """A file is cut short, or does not hold what it should."""


class NotWritten(WhippleError):
    """The run has not written what was asked for: no fields, no summary yet."""


class Unknown(WhippleError, KeyError):
    """There is nothing of this name; or it cannot be told from this run."""


class Named(dict):
    """A dictionary that says what it holds when it is asked for something else.

    kind: what one entry is called in the message."""

    def __init__(self, entries, kind):
        super().__init__(entries)
        self.kind = kind

    def __missing__(self, key):
        raise Unknown(f"there is no {self.kind} '{key}'; there is: {', '.join(map(str, self)) or 'none'}")
