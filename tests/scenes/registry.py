"""The scenes: small drawings of one thing each, in the colours that show its fault.

`@scene()` over a function `(g: PGraphics) -> None` is all that it takes: the function's name is the
scene's. It draws the first frame of a sketch. `make_processing_goldens.py` runs it on Processing
too, so it uses nothing but `g`, constants, `math`, `PMatrix3D`, functions of its own file that take
`g`, and `createGraphics` from here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from sketchkit.api.graphics import PGraphics
from sketchkit.core.constants import P2D

Drawing = Callable[[PGraphics], None]

SCENES: dict[str, Scene] = {}
FOLDER = Path(__file__).parent  # files are found in its `data`, as a sketch's are


@dataclass(frozen=True)
class Scene:
    """A drawing, and how exactly it has to be met.

    Attributes
    ----------
    gl_tolerance : int
        By how much a channel may differ between OpenGL and the CPU renderer, in all but one of
        2,000 pixels.
    processing_share : float
        Share of the pixels that must be within 2/255 of Processing's.
    runs_glsl : bool
        Whether shaders of its own draw it: the CPU renderer cannot, and is left out.
    why : str
        The reason for figures other than the usual ones.
    """

    name: str
    draw: Drawing
    size: tuple[int, int]
    renderer: str
    samples: int
    gl_tolerance: int
    processing_share: float
    runs_glsl: bool
    why: str


USUAL_TOLERANCE = 2
USUAL_SHARE = 0.995


def scene(  # noqa: PLR0913 # all are given by name, few at a time
    renderer: str = P2D,
    *,
    size: tuple[int, int] = (100, 100),
    is_smooth: bool = True,
    runs_glsl: bool = False,
    gl_tolerance: int = USUAL_TOLERANCE,
    processing_share: float = USUAL_SHARE,
    why: str = "",
) -> Callable[[Drawing], Drawing]:
    """Make a scene of the function below."""
    is_usual = (gl_tolerance, processing_share) == (USUAL_TOLERANCE, USUAL_SHARE)

    def register(draw: Drawing) -> Drawing:
        name = draw.__name__
        if is_usual == bool(why) or name in SCENES:
            raise ValueError(f"scene {name}: unusual figures need a reason, and names are unique")
        samples = 4 if is_smooth else 1
        SCENES[name] = Scene(
            name, draw, size, renderer, samples, gl_tolerance, processing_share, runs_glsl, why
        )
        return draw

    return register


def createGraphics(g: PGraphics, width: int, height: int, renderer: str) -> PGraphics:
    """Return a canvas out of sight, as a sketch's own function does."""
    return g.offscreen(width, height, renderer, g.target.samples)
