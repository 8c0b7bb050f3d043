"""`python -m sketchkit` is the command `sketchkit`."""

import sys

if not sys.flags.safe_path:
    del sys.path[0]  # the folder we are in: a student's math.py there is not Python's

from sketchkit.cli.start import start  # see above

start()
