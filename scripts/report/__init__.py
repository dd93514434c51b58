# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages that say everything about a run or a study in one file that opens anywhere, without a network."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import pictures  # noqa: E402,F401  finds whipple, draws without a screen
