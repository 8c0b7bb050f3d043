"""Stage: what rows are drawn with, apart from their own numbers and their style."""

from __future__ import annotations

from dataclasses import dataclass

from sketchkit.core.lights import LightRig
from sketchkit.core.matrix import IDENTITY4, Affine, Mat4
from sketchkit.draw.pipeline import Blend, Clip
from sketchkit.draw.resources import Target, Wrap
from sketchkit.draw.shading import BUILT_IN, Shadings


@dataclass(frozen=True, eq=False, slots=True)
class Stage:
    """Everything of a pipeline that a sketch sets for more than one shape.

    A change makes a new stage, and a new stage begins a new section: within a section of a 3D
    canvas all fills are drawn before all strokes, and these before all points, as Processing does.

    Attributes
    ----------
    is_3d : bool
        Whether strokes face the viewer (P3D) or are outlines in the plane (P2D).
    is_java2d : bool
        Whether it follows JAVA2D: outlines begin at the middle of a pixel, fills are not moved to
        whole pixels, and corners of images are cut off to whole numbers.
    lights : LightRig or None
        None is unlit; an empty rig is lit by nothing.
    one_by_one : bool
        Whether each shape is a section of its own, so that its strokes come before later fills;
        they lie where they are then, and are not pulled toward the eye.
    sighting : Affine or None
        For what is retained, the modelview under which it is first seen: how large round things
        are on the screen decides their number of sides. None for what is drawn at once.
    """

    target: Target
    is_3d: bool = False
    is_java2d: bool = False
    projection: Mat4 = IDENTITY4
    is_perspective: bool = True
    blend: Blend = Blend.BLEND
    depth_test: bool = False
    depth_write: bool = True
    depth_sort: bool = False
    clip: Clip | None = None
    lights: LightRig | None = None
    wrap: Wrap = Wrap.CLAMP
    stroke_perspective: bool = False
    one_by_one: bool = False
    sighting: Affine | None = None
    shadings: Shadings = BUILT_IN
