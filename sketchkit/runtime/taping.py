"""A sketch without a window, and without pictures: what it draws goes onto a tape.

Between what is drawn stand messages about the sketch itself: `frame` at the end of each frame, with
the values that were watched, `remark`, `mistake`, and `end` when it has come to its end.
"""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from sketchkit.core.clock import VirtualClock
from sketchkit.draw.backend import Backend
from sketchkit.runtime.headless import Launch, Steps, opened
from sketchkit.runtime.loader import seed_everything
from sketchkit.runtime.report import StoppedError
from sketchkit.runtime.watching import number_at
from sketchkit.tape.messages import Message
from sketchkit.tape.recording import TapeRenderer
from sketchkit.tape.writing import Send


def record(
    launch: Launch,
    last: int,
    send: Send,
    open_backend: Callable[[], Backend],
    watched: Sequence[str] = (),
) -> None:
    """Run a sketch up to a frame, and write down what it draws.

    Parameters
    ----------
    launch : Launch
        What it tells goes onto the tape too.
    last : int
        The last frame that is wanted.
    send : callable
        Takes each message.
    open_backend : callable
        Returns what draws, should the sketch read its own picture.
    watched : sequence of str
        Values of the sketch, see `number_at`.
    """
    say = launch.tell

    def tell(path: Path, line: int, text: str) -> None:
        say(path, line, text)
        send(Message("remark", [path.name, line, text]))

    renderer = TapeRenderer(send, open_backend)
    clock = VirtualClock()
    launch = replace(launch, tell=tell)
    try:
        with opened(launch, renderer, clock) as loop:
            seed_everything(launch.seed)
            steps = Steps(loop, clock, launch.replay)
            loop.begin()
            _mark(steps, renderer, watched)
            while steps.frame < last and steps.can_go_on:
                steps.step()
                _mark(steps, renderer, watched)
            loop.end()
    except StoppedError as stopped:
        report = stopped.report
        send(Message("mistake", [report.path.name, report.line, str(report)]))
        return
    send(Message("end", steps.frame))


def _mark(steps: Steps, renderer: TapeRenderer, watched: Sequence[str]) -> None:
    """Write that a frame is complete."""
    program = steps.loop.program
    names = ChainMap(program.namespace, program.names)
    renderer.flush()
    number = renderer.tape.number_of(program.sketch.canvas.target)
    values = [number_at(path, names) for path in watched]
    renderer.send(Message("frame", {"number": steps.frame, "canvas": number, "values": values}))
