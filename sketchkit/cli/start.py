"""Where the command `sketchkit` begins: before anything is loaded, the hashes of text are fixed.

Python gives texts other hashes in each process, and the order of a set hangs on them. A sketch that
walks through a set would draw another picture each time.
"""

from __future__ import annotations

import importlib
import os
import subprocess
import sys

FIXED = ("render", "trace")  # commands whose output is the same each time
VARIABLE = "PYTHONHASHSEED"


def start() -> None:
    """Run the command with the arguments of the shell."""
    if len(sys.argv) > 1 and sys.argv[1] in FIXED and VARIABLE not in os.environ:
        _begin_again()
    # Not loaded before, since it may be for nothing.
    importlib.import_module("sketchkit.cli.main").main(prog_name="sketchkit")


def _begin_again() -> None:
    """Start Python anew with fixed hashes: a running one cannot change them."""
    os.environ[VARIABLE] = "0"
    arguments = [sys.executable, *sys.orig_argv[1:]]
    if os.name == "posix":
        os.execv(sys.executable, arguments)
    sys.exit(subprocess.run(arguments, check=False).returncode)
