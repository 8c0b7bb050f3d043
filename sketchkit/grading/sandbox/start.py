"""`python -m sketchkit.grading.sandbox.start MODULE ARGS`: what runs first in the sandbox.

It is ours, and trusted. It puts up the walls that a process can only put up around itself, says
that they are up, and runs the job's module behind them.
"""

from __future__ import annotations

import os
import runpy
import sys

from sketchkit.grading.sandbox import inside
from sketchkit.grading.sandbox.job import SandboxError
from sketchkit.grading.sandbox.plan import OUTPUT, Plan

ASIDE, HIGHEST = 100, 4096  # file descriptors: where none is inherited, and above all that are


def main() -> None:
    """Put up the walls, and run a module behind them."""
    plan = inside.plan()
    try:
        ready = _arrange_files(plan)
        inside.lock_down()
    except SandboxError as reason:
        sys.exit(str(reason))
    if ready is not None:
        os.write(ready, b"1")
        os.close(ready)
    sys.argv = sys.argv[1:]
    runpy.run_module(sys.argv[0], run_name="__main__", alter_sys=True)


def _arrange_files(plan: Plan) -> int | None:
    """Put the output at descriptor 3 and close all that was inherited; return where to say ready.

    Bubblewrap leaves open what it was given; nothing of that may reach a sketch.
    """
    if sys.platform == "win32":
        output = os.open(plan.output or os.devnull, os.O_WRONLY | os.O_APPEND | os.O_BINARY)
        os.dup2(output, OUTPUT)
        return None
    import fcntl

    output = os.open(os.devnull, os.O_WRONLY) if plan.output is None else int(plan.output)
    # First out of the way, so that neither is put where the other still lies.
    output, ready = (fcntl.fcntl(one, fcntl.F_DUPFD, ASIDE) for one in (output, plan.ready))
    os.dup2(output, OUTPUT)
    os.dup2(ready, OUTPUT + 1)
    os.closerange(OUTPUT + 2, HIGHEST)
    return OUTPUT + 1


if __name__ == "__main__":
    main()
