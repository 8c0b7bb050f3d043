"""A renderer that writes a tape. It draws only if the sketch asks what its picture looks like."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence

import numpy as np

from sketchkit.draw.backend import Backend
from sketchkit.draw.commands import DrawList, Upload
from sketchkit.draw.meshes import Mesh
from sketchkit.draw.recorder import Recorder
from sketchkit.draw.renderer import Renderer
from sketchkit.draw.resources import Pixels, Target
from sketchkit.draw.shading import ShaderSource
from sketchkit.draw.vertex import U8
from sketchkit.tape.messages import Message, read_messages
from sketchkit.tape.playing import Player
from sketchkit.tape.writing import Send, TapeWriter

MOST_WAITING = 64 << 20  # bytes: beyond it, what was recorded is drawn after all


class TapeRenderer(Renderer):
    """Writes down what it is given.

    Parameters
    ----------
    send : callable
        Takes each message of the tape.
    open_backend : callable
        Returns what draws, when the sketch reads its own picture or makes a shader.
    """

    def __init__(self, send: Send, open_backend: Callable[[], Backend]) -> None:
        self._late = LateBackend(open_backend)
        self._send = send
        self.tape = TapeWriter(self.send)
        self._late.number_of = self.tape.number_of
        super().__init__(self._late)

    def send(self, message: Message) -> None:
        """Put a message on the tape."""
        self._send(message)
        self._late.wait(message)

    def upload(self, uploads: Sequence[Upload]) -> None:
        """Write pixels that the sketch has set."""
        self.tape.write_uploads(uploads)
        for reader in self.readers:
            reader.read_commands(DrawList(list(uploads)))

    def assemble(self, recorder: Recorder) -> DrawList | None:
        """Write what a recorder holds; only what reads along needs a list."""
        self.tape.write_recorder(recorder)
        if self.readers and (commands := super().assemble(recorder)) is not None:
            for reader in self.readers:
                reader.read_commands(commands)
        return None


class LateBackend:
    """Draws nothing before it has to.

    Attributes
    ----------
    number_of : callable
        Returns a target's number on the tape.
    """

    name = "tape"
    number_of: Callable[[Target], int]

    def __init__(self, open_backend: Callable[[], Backend]) -> None:
        self._open = open_backend
        self._backend: Backend | None = None
        self._player: Player | None = None
        self._waiting: list[bytes] = []
        self._size = 0

    def wait(self, message: Message) -> None:
        """Take a message that is drawn when a picture is asked for."""
        data = bytes(message)
        self._waiting.append(data)
        self._size += len(data)
        if self._size > MOST_WAITING:
            self._catch_up()

    def describe(self) -> dict[str, str]:
        """Return what would draw, in words."""
        return self._drawing().describe()

    def execute(self, commands: DrawList) -> None:
        """Refuse: whoever writes a tape makes no lists."""
        raise AssertionError("a tape is written before there is a list")

    def prepare(self, source: ShaderSource) -> None:
        """Compile a shader: the sketch is to know at once what is wrong with it."""
        self._drawing().prepare(source)

    def read(self, target: Target) -> U8:
        """Return what was drawn, after all."""
        number = self.number_of(target)
        player = self._catch_up()
        if number not in player.resources:
            return np.zeros((target.height, target.width, 4), np.uint8)
        return player.read(number)

    def read_pixel(self, target: Target, x: int, y: int) -> U8:
        """Return one pixel of it."""
        pixel: U8 = self.read(target)[y, x]
        return pixel

    def forget(self, resource: Pixels | Target | Mesh) -> None:
        """Do nothing: no copy is kept under this identity."""

    def close(self) -> None:
        """Let go of everything."""
        self._waiting.clear()
        if self._backend is not None:
            self._backend.close()

    def _drawing(self) -> Backend:
        if self._backend is None:
            self._backend = self._open()
        return self._backend

    def _catch_up(self) -> Player:
        """Draw what was recorded so far."""
        if self._player is None:
            self._player = Player(Renderer(self._drawing()))
        waiting, self._waiting, self._size = self._waiting, [], 0
        for message in read_messages(io.BytesIO(b"".join(waiting))):
            self._player.play(message)
        return self._player
