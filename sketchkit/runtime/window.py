"""The window: the only place that knows GLFW."""

from __future__ import annotations

import ctypes
import time
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import Any

import glfw

from sketchkit.api.host import NoWindow
from sketchkit.backends.gl.context import NoContextError
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.core.constants import ARROW, CROSS, HAND, MOVE, SPAN, TEXT, WAIT
from sketchkit.draw.resources import Target
from sketchkit.draw.vertex import U8
from sketchkit.runtime import desktop
from sketchkit.runtime.events import AnyEvent, WindowEvent
from sketchkit.runtime.headless import FIRST_SIZE
from sketchkit.runtime.keys import Keys
from sketchkit.runtime.mouse import Mouse
from sketchkit.runtime.screens import area_of, middle_of, monitor_of, refresh_rate

GL_VERSION = 3, 3  # the newest that macOS, Windows and Linux all have
COARSE_S = 0.002  # how early waiting for events ends, where the system's clock ticks slowly
FINE_SCALE = 1.5  # from which scale of its content a screen counts as one of high density
CURSORS = {
    ARROW: glfw.ARROW_CURSOR,
    CROSS: glfw.CROSSHAIR_CURSOR,
    HAND: glfw.HAND_CURSOR,
    MOVE: glfw.RESIZE_ALL_CURSOR,
    TEXT: glfw.IBEAM_CURSOR,
    WAIT: glfw.ARROW_CURSOR,  # GLFW has no clock
}


MODIFIERS = 1, 1, 2, 2, 4, 4, 8, 8
MODIFIER_KEYS = (
    *(glfw.KEY_LEFT_SHIFT, glfw.KEY_RIGHT_SHIFT, glfw.KEY_LEFT_CONTROL, glfw.KEY_RIGHT_CONTROL),
    *(glfw.KEY_LEFT_ALT, glfw.KEY_RIGHT_ALT, glfw.KEY_LEFT_SUPER, glfw.KEY_RIGHT_SUPER),
)


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
            (glfw.AUTO_ICONIFY, glfw.FALSE),  # a full screen stays when another one is clicked
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
        self._is_damaged = self._is_hidden = self._is_placed = self._covers_all = False
        self._keys = Keys()
        self._mouse = Mouse()
        self._events: list[AnyEvent] = []
        self._cursors: dict[object, Any] = {}  # Any: GLFW's own pointers
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

    def now(self) -> float:
        """Return the time, in seconds from whenever."""
        return time.perf_counter()

    def wait(self, timeout_s: float) -> Sequence[AnyEvent]:
        """Return what has happened, at the latest after a while.

        The last moments are slept, as GLFW's own waiting is coarse on some systems: what happens
        in them is heard right after.
        """
        if timeout_s > COARSE_S:
            glfw.wait_events_timeout(timeout_s - COARSE_S)
        else:
            if timeout_s > 0:
                time.sleep(timeout_s)
            glfw.poll_events()
        self._events += self._keys.settle()
        events, self._events = self._events, []
        return events

    def pace(self, frames_per_second: float) -> None:
        """Wait for the display from now on, if it is no faster than the sketch."""
        rate = refresh_rate()
        waits = rate is not None and frames_per_second >= rate - 1
        if waits != self._interval:
            glfw.swap_interval(int(waits))
            self._interval = waits

    def show(self, target: Target) -> None:
        """Show a picture."""
        if not self._is_hidden and not glfw.get_window_attrib(self._window, glfw.VISIBLE):
            self._place()
            glfw.show_window(self._window)
        self._is_damaged = False
        self.backend.present(target, glfw.get_framebuffer_size(self._window))
        glfw.swap_buffers(self._window)

    @property
    def is_damaged(self) -> bool:
        """Whether what was shown is lost, as when another window lay over it."""
        return self._is_damaged

    # What the sketch may ask (api.host.Host)

    @property
    def density(self) -> int:
        """How many pixels of the screen there may be for one of the sketch's: 1 or 2."""
        return 2 if max(glfw.get_window_content_scale(self._window)) >= FINE_SCALE else 1

    @property
    def position(self) -> tuple[int, int]:
        """Left and top edge of the window on the screen."""
        x, y = glfw.get_window_pos(self._window)
        return x, y

    @property
    def is_focused(self) -> bool:
        """Whether keys go to the window."""
        return bool(glfw.get_window_attrib(self._window, glfw.FOCUSED))

    def display_size(self, display: int | None = None) -> tuple[int, int]:
        """Return width and height of a screen: by number from 1, of all for 0, of the main one."""
        area = area_of(display)
        return self._in_units(*area[2:]) if area else NoWindow().display_size()

    def set_size(self, width: int, height: int) -> None:
        """Follow the canvas, which has got another size."""
        if self._covers_all:
            self._leave_fullscreen()
        self._size = width, height
        unit = self._unit
        glfw.set_window_size(self._window, round(width * unit), round(height * unit))

    def set_fullscreen(self, display: int | None = None) -> None:
        """Cover a screen, or all of them for 0."""
        area = area_of(display)
        if area is None:
            return
        x, y, width, height = area
        self._size, self._covers_all = self._in_units(width, height), True
        self._is_placed = True
        if display == SPAN:
            glfw.set_window_attrib(self._window, glfw.DECORATED, glfw.FALSE)
            glfw.set_window_pos(self._window, x, y)
            glfw.set_window_size(self._window, width, height)
            return
        rate = glfw.DONT_CARE
        glfw.set_window_monitor(self._window, monitor_of(display), 0, 0, width, height, rate)

    def set_title(self, title: str) -> None:
        """Write on the window's edge."""
        glfw.set_window_title(self._window, title)

    def set_position(self, x: int, y: int) -> None:
        """Move the window."""
        self._is_placed = True
        glfw.set_window_pos(self._window, x, y)

    def set_resizable(self, is_resizable: bool) -> None:
        """Let the user change the window's size, or not."""
        glfw.set_window_attrib(self._window, glfw.RESIZABLE, is_resizable)

    def set_visible(self, is_visible: bool) -> None:
        """Show the window, or hide it."""
        self._is_hidden = not is_visible
        (glfw.show_window if is_visible else glfw.hide_window)(self._window)

    def set_always_on_top(self, is_on_top: bool) -> None:
        """Keep the window above all others, or not."""
        glfw.set_window_attrib(self._window, glfw.FLOATING, is_on_top)

    def set_icon(self, pixels: U8) -> None:
        """Give the window an icon, (h, w, 4) RGBA."""
        glfw.set_window_icon(self._window, 1, [_image(pixels)])  # type: ignore[list-item] # the stubs know less than GLFW's wrapper

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

    def set_cursor_image(self, pixels: U8, x: int, y: int) -> None:
        """Show the pointer as an image, of which (x, y) is where it points."""
        glfw.set_input_mode(self._window, glfw.CURSOR, glfw.CURSOR_NORMAL)
        made = pixels.tobytes(), pixels.shape, x, y
        if made not in self._cursors:
            self._cursors[made] = glfw.create_cursor(_image(pixels), x, y)  # type: ignore[arg-type] # the same
        glfw.set_cursor(self._window, self._cursors[made])

    @property
    def _unit(self) -> float:
        """How long a unit of the sketch is, as the system measures windows.

        On some systems that is in pixels of the screen, on others in units that are larger where
        the pixels are fine.
        """
        pixels, _ = glfw.get_framebuffer_size(self._window)
        width, _ = glfw.get_window_size(self._window)
        return max(self.density * max(width, 1) / max(pixels, 1), 1.0)

    def _in_units(self, width: int, height: int) -> tuple[int, int]:
        return round(width / self._unit), round(height / self._unit)

    def _place(self) -> None:
        """Put the window in the middle of the screen, unless it has its place already."""
        place = middle_of(*glfw.get_window_size(self._window))
        if place and not self._is_placed:
            glfw.set_window_pos(self._window, *place)
        self._is_placed = True

    def _leave_fullscreen(self) -> None:
        self._covers_all = self._is_placed = False
        glfw.set_window_attrib(self._window, glfw.DECORATED, glfw.TRUE)
        width, height = self._size
        glfw.set_window_monitor(self._window, None, 0, 0, width, height, glfw.DONT_CARE)  # type: ignore[arg-type] # None is no screen
        self._place()

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
        glfw.set_window_refresh_callback(window, self._on_damage)
        glfw.set_window_focus_callback(window, self._on_focus)

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
        self._events += self._mouse.move(x, y, _millis(), self._held())

    def _on_button(self, _: object, number: int, action: int, modifiers: int) -> None:
        happened = self._mouse.press if action == glfw.PRESS else self._mouse.release
        self._events += happened(number, modifiers, _millis())

    def _on_scroll(self, _: object, x: float, y: float) -> None:
        self._events += self._mouse.scroll(y, _millis(), self._held())

    def _on_edge(self, _: object, is_inside: int) -> None:
        self._events += self._mouse.cross_edge(bool(is_inside), _millis(), self._held())

    def _on_size(self, _: object, width: int, height: int) -> None:
        is_wanted = glfw.get_window_attrib(self._window, glfw.RESIZABLE)
        size = self._in_units(width, height)
        if is_wanted and size != self._size and all(size):
            self._size = size
            self._events.append(WindowEvent("windowResized", size))

    def _on_position(self, _: object, x: int, y: int) -> None:
        self._events.append(WindowEvent("windowMoved"))

    def _on_damage(self, _: object) -> None:
        self._is_damaged = True

    def _on_focus(self, _: object, is_focused: int) -> None:
        self._events.append(WindowEvent("focusGained" if is_focused else "focusLost"))

    def _held(self) -> int:
        """Return which of Shift, Control, Alt and Command are held, as GLFW's sum."""
        pressed = (glfw.get_key(self._window, key) == glfw.PRESS for key in MODIFIER_KEYS)
        return sum(
            {modifier for modifier, is_held in zip(MODIFIERS, pressed, strict=True) if is_held}
        )


def _image(pixels: U8) -> tuple[int, int, list[list[list[int]]]]:
    """Return an image as GLFW takes it."""
    height, width = pixels.shape[:2]
    return width, height, pixels.tolist()


def _millis() -> int:
    return int(glfw.get_time() * 1000)


def _reason() -> str:
    """Return what GLFW says about its last failure."""
    _, text = glfw.get_error()
    return text.decode() if isinstance(text, bytes) else text or "GLFW gives no reason"


def _address_of(name: str) -> int:
    """Return the address of a function of OpenGL, 0 if there is none."""
    return ctypes.cast(glfw.get_proc_address(name), ctypes.c_void_p).value or 0
