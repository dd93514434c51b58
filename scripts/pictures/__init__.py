# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of runs: plot_run.py and the report use these. Needs python3-matplotlib and python3-h5py."""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import package  # noqa: E402,F401  whipple

import matplotlib  # noqa: E402

matplotlib.use("Agg")
