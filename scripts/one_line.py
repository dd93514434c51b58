# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of the scripts that users call: what is wrong is said in one line, exit status 2."""
import argparse
import sys


class OneLine(argparse.ArgumentParser):
    """As argparse, without the usage before each complaint."""

    def __init__(self, verb, description):
        super().__init__(description=description, formatter_class=argparse.RawDescriptionHelpFormatter, allow_abbrev=False)
        self.verb = verb

    def error(self, message):
        print(f"{self.verb}: {message}", file=sys.stderr)
        sys.exit(2)
