"""The assignment of the class of sixty: two lit boxes, one behind the other, that turn."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

TITLE = "Two boxes"
SECRET = "the reference's own secret, 8f2d6c"

REFERENCE = f"""\
# {SECRET}
angle = 0.0

def setup():
    size(120, 90, P3D)
    noStroke()

def draw():
    global angle
    angle = frameCount * 0.1
    background(30, 40, 60)
    lights()
    fill(220, 120, 40)
    with pushMatrix():
        translate(45, 40, 20)
        rotateY(angle)
        box(30)
    fill(60, 200, 90)
    with pushMatrix():
        translate(65, 50, -15)
        rotateX(angle)
        box(40, 30, 30)
    fill(240, 240, 0)
    translate(15, 75)
    rect(0, 0, 12, 6)
"""

CHECKS = """\
title = "Two boxes"
renderer = "cpu"
seed = 7

[limits]
cpu_s = 5
wall_s = 12
memory_mb = 1024
output_mb = 32

[[checks]]
kind = "image"
name = "The picture"
points = 6
frames = "1,10,20"

[[checks]]
kind = "trace"
name = "How it is drawn"
points = 2
frames = "10"
kinds = { box = 2 }
nesting = ">= 1"
lights = 2

[[checks]]
kind = "motion"
name = "It turns"
points = 1
frames = "1-20"
values = ["angle"]
tolerance = 0.01

[[checks]]
kind = "source"
name = "Its text"
points = 1
calls = ["box", "lights"]
"""


def write_assignment(folder: Path, checks: str = CHECKS) -> Path:
    """Write the assignment's folder; return it."""
    (folder / "reference").mkdir(parents=True)
    (folder / "assignment.toml").write_text(checks, encoding="utf-8")
    (folder / "reference" / "reference.py").write_text(dedent(REFERENCE), encoding="utf-8")
    return folder
