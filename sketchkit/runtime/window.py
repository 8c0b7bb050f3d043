"""The window: the only place that knows GLFW."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Any

import glfw

from sketchkit.api.host import NoWindow
from sketchkit.backends.gl.context import NoContextError
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.core.constants import ARROW, CROSS, HAND, MOVE, TEXT, WAIT
from sketchkit.draw.resources import Target
from sketchkit.runtime import desktop
from sketchkit.runtime.events import AnyEvent, WindowEvent
from sketchkit.runtime.headless import FIRST_SIZE
from sketchkit.runtime.keys import Keys
from sketchkit.runtime.mouse import Mouse

GL_VERSION = 3, 3  # the newest that macOS, Windows and Linux all have
CURSORS = {
    ARROW: glfw.ARROW_CURSOR,
    CROSS: glfw.CROSSHAIR_CURSOR,
    HAND: glfw.HAND_CURSOR,
    MOVE: glfw.RESIZE_ALL_CURSOR,
    TEXT: glfw.IBEAM_CURSOR,
    WAIT: glfw.ARROW_CURSOR,  # GLFW has no clock
}


class WindowError(Exception):
    """No window can be opened here; the message is a sentence that says why."""


class Window:
    """A window with an OpenGL context; it is a `Screen` of the player. A block closes it.

    Parameters
    ----------
    title : str
        What stands on its edge at first.

    Raises
    ------
    WindowError
        If there is no display, or no OpenGL 3.3.
    """

    def __init__(self, title: str) -> None:
        glfw.ERROR_REPORTING = "ignore"  # each failure is looked at here
        if not glfw.init():
            raise WindowError(_reason())
        for hint, value in (
            (glfw.CONTEXT_VERSION_MAJOR, GL_VERSION[0]),
            (glfw.CONTEXT_VERSION_MINOR, GL_VERSION[1]),
            (glfw.OPENGL_PROFILE, glfw.OPENGL_CORE_PROFILE),
            (glfw.OPENGL_FORWARD_COMPAT, glfw.TRUE),  # macOS has no other
            (glfw.VISIBLE, glfw.FALSE),  # until size() says how large it is
            (glfw.RESIZABLE, glfw.FALSE),
        ):
            glfw.window_hint(hint, value)
        self._window = glfw.create_window(FIRST_SIZE, FIRST_SIZE, title, None, None)
        if not self._window:
            raise WindowError(_reason())
        glfw.make_context_current(self._window)
        try:
            self.backend = GlBackend.for_window(_address_of)
        except NoContextError as reason:
            raise WindowError(str(reason)) from reason
        self._size = FIRST_SIZE, FIRST_SIZE  # the canvas's: the window manager may want another
        self._interval: int | None = None
        self._keys = Keys()
        self._mouse = Mouse()
        self._events: list[AnyEvent] = []
        self._cursors: dict[int, Any] = {}  # Any: GLFW's own pointers
        self._listen()

    def __enter__(self) -> Window:
        """Return itself."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        """Close the window."""
        self.backend.close()
        glfw.terminate()

    # What the player needs

    @property
    def is_closed(self) -> bool:
        """Whether the user has closed it."""
        return bool(glfw.window_should_close(self._window))

    def wait(self, timeout_s: float) -> Sequence[AnyEvent]:
        """Return what has happened, at the latest after a while."""
        if timeout_s > 0:
            glfw.wait_events_timeout(timeout_s)
        else:
            glfw.poll_events()
        self._events += self._keys.settle()
        events, self._events = self._events, []
        return events

    def pace(self, frames_per_second: float) -> None:
        """Wait for the display from now on, if it is no faster than the sketch."""
        mode = _video_mode()
        waits = mode is not None and frames_per_second >= mode.refresh_rate - 1
        if waits != self._interval:
            glfw.swap_interval(int(waits))
            self._interval = waits

    def show(self, target: Target) -> None:
        """Show a picture."""
        if not glfw.get_window_attrib(self._window, glfw.VISIBLE):
            glfw.show_window(self._window)
        self.backend.present(target, glfw.get_framebuffer_size(self._window))
        glfw.swap_buffers(self._window)

    # What the sketch may ask (api.host.Host)

    @property
    def display_size(self) -> tuple[int, int]:
        """Width and height of the screen."""
        mode = _video_mode()
        return (mode.size.width, mode.size.height) if mode else NoWindow.display_size

    @property
    def position(self) -> tuple[int, int]:
        """Left and top edge of the window on the screen."""
        x, y = glfw.get_window_pos(self._window)
        return x, y

    @property
    def is_focused(self) -> bool:
        """Whether keys go to the window."""
        return bool(glfw.get_window_attrib(self._window, glfw.FOCUSED))

    def set_size(self, width: int, height: int) -> None:
        """Follow the canvas, which has got another size."""
        self._size = width, height
        glfw.set_window_size(self._window, width, height)

    def set_fullscreen(self) -> None:
        """Cover the screen."""
        width, height = self._size = self.display_size
        monitor = glfw.get_primary_monitor()
        glfw.set_window_monitor(self._window, monitor, 0, 0, width, height, glfw.DONT_CARE)

    def set_title(self, title: str) -> None:
        """Write on the window's edge."""
        glfw.set_window_title(self._window, title)

    def set_position(self, x: int, y: int) -> None:
        """Move the window."""
        glfw.set_window_pos(self._window, x, y)

    def set_resizable(self, is_resizable: bool) -> None:
        """Let the user change the window's size, or not."""
        glfw.set_window_attrib(self._window, glfw.RESIZABLE, is_resizable)

    def set_visible(self, is_visible: bool) -> None:
        """Show the window, or hide it."""
        (glfw.show_window if is_visible else glfw.hide_window)(self._window)

    def set_cursor(self, kind: int | None) -> None:
        """Show the pointer in one of its shapes; None hides it."""
        mode = glfw.CURSOR_HIDDEN if kind is None else glfw.CURSOR_NORMAL
        glfw.set_input_mode(self._window, glfw.CURSOR, mode)
        if kind is not None:
            if kind not in self._cursors:
                self._cursors[kind] = glfw.create_standard_cursor(CURSORS[kind])
            glfw.set_cursor(self._window, self._cursors[kind])

    def open_link(self, url: str) -> None:
        """Show a page in the browser."""
        desktop.open_link(url)

    def launch(self, arguments: Sequence[str]) -> None:
        """Open a file with its program, or start a program."""
        desktop.launch(arguments)

    def choose_file(
        self, kind: str, prompt: str, start: str, then: Callable[[str | None], None]
    ) -> None:
        """Ask for a path while the sketch goes on."""
        desktop.choose_file(kind, prompt, start, then)

    # Events

    def _listen(self) -> None:
        window = self._window
        glfw.set_key_callback(window, self._on_key)
        glfw.set_char_callback(window, self._on_character)
        glfw.set_cursor_pos_callback(window, self._on_move)
        glfw.set_mouse_button_callback(window, self._on_button)
        glfw.set_scroll_callback(window, self._on_scroll)
        glfw.set_cursor_enter_callback(window, self._on_edge)
        glfw.set_window_size_callback(window, self._on_size)
        glfw.set_window_pos_callback(window, self._on_position)

    def _on_key(self, _: object, code: int, scancode: int, action: int, modifiers: int) -> None:
        if action == glfw.RELEASE:
            self._events += self._keys.release(code, modifiers, millis=_millis())
        else:
            is_repeat = action == glfw.REPEAT
            self._events += self._keys.press(code, modifiers, is_repeat=is_repeat, millis=_millis())

    def _on_character(self, _: object, codepoint: int) -> None:
        self._events += self._keys.character(chr(codepoint))

    def _on_move(self, _: object, x: float, y: float) -> None:
        window_width, window_height = glfw.get_window_size(self._window)
        width, height = self._size
        x, y = x * width / max(window_width, 1), y * height / max(window_height, 1)
        self._events += self._mouse.move(x, y, _millis())

    def _on_button(self, _: object, number: int, action: int, modifiers: int) -> None:
        happened = self._mouse.press if action == glfw.PRESS else self._mouse.release
        self._events += happened(number, modifiers, _millis())

    def _on_scroll(self, _: object, x: float, y: float) -> None:
        self._events += self._mouse.scroll(y, _millis())

    def _on_edge(self, _: object, is_inside: int) -> None:
        self._events += self._mouse.cross_edge(bool(is_inside), _millis())

    def _on_size(self, _: object, width: int, height: int) -> None:
        is_wanted = glfw.get_window_attrib(self._window, glfw.RESIZABLE)
        if is_wanted and (width, height) != self._size and width and height:
            self._size = width, height
            self._events.append(WindowEvent("windowResized", (width, height)))

    def _on_position(self, _: object, x: int, y: int) -> None:
        self._events.append(WindowEvent("windowMoved"))


def _video_mode() -> Any:  # noqa: ANN401 # Any: GLFW's own structure
    """Return size and refresh rate of the screen; None if there is none, only a display."""
    monitor = glfw.get_primary_monitor()
    return glfw.get_video_mode(monitor) if monitor else None


def _millis() -> int:
    return int(glfw.get_time() * 1000)


def _reason() -> str:
    """Return what GLFW says about its last failure."""
    _, text = glfw.get_error()
    return text.decode() if isinstance(text, bytes) else text or "GLFW gives no reason"


def _address_of(name: str) -> int:
    """Return the address of a function of OpenGL, 0 if there is none."""
    return ctypes.cast(glfw.get_proc_address(name), ctypes.c_void_p).value or 0
