"""An assignment to begin with: what `sketchkit grade init` writes, each key with a comment."""

from __future__ import annotations

from pathlib import Path

from sketchkit.assets.output import write_file
from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.assignment.table import FILE_NAME

ASSIGNMENT = """\
# An assignment for sketchkit grade. Change it step by step, and prove it after each:
#
#     sketchkit grade check .
#
# The reference must score full marks, and an empty sketch none.

title = "A ball that crosses"

renderer = "cpu"         # the same pictures on every computer; "gl" for sketches with shaders
seed = 0                 # where random() and noise() begin
# data = "data"          # a folder whose files each sketch is given; "data", if it is there

# These hold for each check that does not say otherwise:
reference = "reference"  # a sketch that does what you ask for, or a folder of frame-0001.png ...;
                         # ["reference", "other"] if there are several good answers
frames = "1,30"          # which frames are looked at: 3, 1,30, 1-60 or 1-60:5
# input = "events.json"  # mouse and keys that are replayed

[limits]                 # of each submission
cpu_s = 20               # seconds of computing
wall_s = 60              # seconds by the clock: also holds a sketch that only waits
memory_mb = 1024         # megabytes
output_mb = 64           # of files and printed text

# Each check has a kind and points. Strike out those that you do not need.

[[checks]]
kind = "image"           # frames look as the reference's do
name = "The ball is there"
points = 4
expect = "A round ball moves from left to right over a white background."
                         # for students, when they lose marks here
metric = "flip"          # what an eye sees of the difference; or "pixels"
# tolerance = {...}      # the README of sketches/grading says what each metric takes
none_at = 4              # no marks from 4 times the tolerance on, evenly between;
                         # or curve = "all or nothing", or curve = [[1, 1.0], [2, 0.5], [4, 0]]

[[checks]]
kind = "sequence"        # many frames; the animation may be early or late
name = "It moves"
points = 2
frames = "5-60:5"
shift = 3                # frames

[[checks]]
kind = "interaction"     # frames while mouse and keys are replayed
name = "A click changes the colour"
points = 3
input = "events.json"
frames = "10,20"
expect = "When the mouse is pressed, the ball becomes red."

[[checks]]
kind = "motion"          # variables of the sketch, frame by frame
name = "At the right speed"
points = 2
frames = "1-60"
values = ["x"]           # or "ball.x"
tolerance = 5            # in the variable's unit, about the reference;
                         # or {relative = 0.05}: of the way that the reference goes
                         # or bands = {x = [[1, 0, 40], [60, 180, 220]]}: frame, lowest, highest

[[checks]]
kind = "trace"           # what is drawn, whatever it looks like
name = "One circle"
points = 1
kinds = { ellipse = 1, rect = 0 }
                         # also nesting, lights, retained, textures, canvases, vertices,
                         # draw_calls, and shader = {uniform = "time"};
                         # 3, ">= 3", "2..5", or "as in the reference"

[[checks]]
kind = "source"          # what the code has, by its syntax tree
name = "It is built as shown"
points = 2
defines = ["draw", "mousePressed"]
calls = ["background", ["circle", "ellipse"]]  # the second: any one of them
# uses = ["for"]         # statements and names
forbids = ["exec"]

[[checks]]
kind = "performance"     # how much a frame gives the renderer to do
name = "Not wasteful"
points = 1
frames = "30"
draw_calls = "<= 10"
vertices = "as in the reference"
curve = "all or nothing"
"""

SKETCH = '''\
"""A ball crosses the window. A click makes it red."""

x = 0.0
is_red = False


def setup():
    size(320, 200)
    noStroke()


def draw():
    global x
    background(255)
    x = 20 + 3 * frameCount
    if is_red:
        fill(200, 40, 40)
    else:
        fill(40, 80, 200)
    circle(x, height / 2, 60)


def mousePressed():
    global is_red
    is_red = True
'''

EVENTS = """\
{
  "events": [
    {"frame": 14, "move": [80, 100]},
    {"frame": 15, "press": "left"},
    {"frame": 16, "release": "left"}
  ]
}
"""

FILES = {FILE_NAME: ASSIGNMENT, "reference/reference.py": SKETCH, "events.json": EVENTS}


def write_starter(folder: Path) -> None:
    """Make a folder with an assignment that is complete; nothing is overwritten.

    Raises
    ------
    AssignmentError
        If one of its files is there already, or the folder is no folder.
    """
    if folder.exists() and not folder.is_dir():
        raise AssignmentError("It is a file, and an assignment is a folder.", file=str(folder))
    for name in FILES:
        if (folder / name).exists():
            raise AssignmentError(
                f"There is a {name} already, which is left as it is.",
                file=str(folder),
                hint="Name another folder.",
            )
    for name, text in FILES.items():
        write_file(folder / name, text.encode())
