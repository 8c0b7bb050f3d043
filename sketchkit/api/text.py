"""Text on a canvas. Letters are images of one atlas, tinted with the fill colour."""

from __future__ import annotations

import math
import operator
from dataclasses import replace
from pathlib import Path

from sketchkit.api.images import IMAGE, Images
from sketchkit.api.pfont import PFont, design_size
from sketchkit.api.style import check_choice
from sketchkit.assets.fonts import FONT_FILES, Face, face, find_face
from sketchkit.core import constants as c
from sketchkit.core.errors import SketchError, shown
from sketchkit.core.matrix import translated
from sketchkit.core.notices import warn_once
from sketchkit.core.style import Typography
from sketchkit.data.strings import nfs
from sketchkit.data.wrapping import wrap
from sketchkit.draw.pipeline import Blend
from sketchkit.draw.recorder import ROW, pack_row8
from sketchkit.geometry.rects import rect_edges

TEXT_USAGE = "x, y [, z] | x, y, width, height"
LEADING = 1.275  # distance of lines, in heights of a letter from ascent to descent
ALIGNMENTS = {c.LEFT: "LEFT", c.CENTER: "CENTER", c.RIGHT: "RIGHT"}
VERTICAL = {c.TOP: "TOP", c.CENTER: "CENTER", c.BASELINE: "BASELINE", c.BOTTOM: "BOTTOM"}
TEXT_MODES = {c.MODEL: "MODEL", c.SHAPE: "SHAPE"}


class Text(Images):
    """Text: drawing and measuring it, and how it is set."""
