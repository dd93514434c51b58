# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes `import whipple` find python/whipple of this repository, installed or not."""
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "python"))
