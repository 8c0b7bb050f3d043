"""The screens of this computer, by number: what `fullScreen(2)` and `displayWidth` are about."""

from __future__ import annotations

from typing import Any

import glfw

from sketchkit.core.constants import SPAN

Area = tuple[int, int, int, int]  # left, top, width, height


def refresh_rate() -> int | None:
    """Return how often the main screen shows a new picture, in a second; None without a screen."""
    monitor = glfw.get_primary_monitor()
    return int(glfw.get_video_mode(monitor).refresh_rate) if monitor else None


def monitor_of(display: int | None) -> Any:  # noqa: ANN401 # Any: GLFW's own pointer
    """Return a screen by its number from 1; the main one if there is none of that number."""
    monitors = glfw.get_monitors()
    is_known = display is not None and 1 <= display <= len(monitors)
    return monitors[display - 1] if is_known and display else glfw.get_primary_monitor()


def area_of(display: int | None) -> Area | None:
    """Return where a screen lies, or all of them together for 0; None without any."""
    monitors = glfw.get_monitors() if display == SPAN else [monitor_of(display)]
    areas = []
    for monitor in filter(None, monitors):
        (x, y), mode = glfw.get_monitor_pos(monitor), glfw.get_video_mode(monitor)
        areas.append((x, y, x + mode.size.width, y + mode.size.height))
    if not areas:
        return None
    left, top = (min(area[side] for area in areas) for side in (0, 1))
    right, bottom = (max(area[side] for area in areas) for side in (2, 3))
    return left, top, right - left, bottom - top


def middle_of(width: int, height: int) -> tuple[int, int] | None:
    """Return where a window of a size lies in the middle of the main screen; None without one."""
    monitor = glfw.get_primary_monitor()
    if not monitor:
        return None
    left, top, room_across, room_down = glfw.get_monitor_workarea(monitor)
    return left + max((room_across - width) // 2, 0), top + max((room_down - height) // 2, 0)
