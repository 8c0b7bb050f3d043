"""Running a stranger's sketch: what it draws goes onto a tape, on descriptor 3.

All walls are up before this is run.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

from sketchkit.draw.backend import Backend
from sketchkit.grading.inside.orders import EVENTS, record_order
from sketchkit.grading.sandbox import inside
from sketchkit.runtime.backends import open_backend
from sketchkit.runtime.headless import Launch
from sketchkit.runtime.replay import Replay, read_replay
from sketchkit.runtime.taping import record
from sketchkit.tape.messages import Message


def main() -> None:
    """Do what the command line says."""
    order = record_order(sys.argv[1])
    replay = read_replay(inside.path(EVENTS)) if order.has_events else Replay()
    path = inside.copy_sketch() / order.sketch
    launch = Launch(path, _say, order.seed, replay=replay)

    def open_renderer() -> Backend:
        return open_backend(order.renderer).backend

    with os.fdopen(inside.OUTPUT, "wb", closefd=False) as out:

        def send(message: Message) -> None:
            out.write(bytes(message))
            if message.kind in ("frame", "mistake", "end"):
                out.flush()  # whatever the sketch does next, this much is known

        record(launch, order.last, send, open_renderer, order.watched)
    inside.leave()


def _say(path: Path, line: int, text: str) -> None:
    """Let a remark stand among what the sketch prints, as in a terminal."""
    print(f"{path.name}, line {line}: {text}", file=sys.stderr)


if __name__ == "__main__":
    main()
