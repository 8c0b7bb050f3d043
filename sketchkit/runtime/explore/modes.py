"""What the explorer's keys switch on, and how they are explained."""

from __future__ import annotations

from typing import NamedTuple

SPEEDS = (1.0, 0.5, 0.2, 0.05)

HELP = (
    "Keys of the explorer: the sketch does not see them",
    "F1   this help",
    "F2   move the camera with the mouse, on or off: drag turns, right drag moves, wheel zooms",
    "F3   back to the sketch's own camera",
    "F4   make a film of what is shown; the same key ends it",
    "F5   pause, and go on",
    "F6   one frame",
    "F7   slower, and at full speed again",
    "F8   inspect: point at something, click to keep it",
    "F9   time of frames, draw calls, vertices",
    "F10  wire frame; then normals too; then off",
    "F11  axes, ground, lights and camera",
    "F12  numbers of the sketch: drag one, or the wheel, or the arrows; Enter writes them",
)


class Modes(NamedTuple):
    """What is switched on.

    Attributes
    ----------
    wire : int
        0: none, 1: edges, 2: normals too.
    speed : int
        Entry of SPEEDS.
    """

    help: bool = False
    camera: bool = False
    inspect: bool = False
    graph: bool = False
    wire: int = 0
    gizmos: bool = False
    numbers: bool = False
    speed: int = 0
