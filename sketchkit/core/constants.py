"""Processing's constants, with Processing's own values.

They are plain numbers (and strings for renderers), as a sketch prints and compares them. Two
names may share a value (`BASELINE` and `CORNER` are both 0): which one is meant, the function says.
"""

import math
from typing import Final

# Renderers
JAVA2D: Final = "processing.awt.PGraphicsJava2D"
P2D: Final = "processing.opengl.PGraphics2D"
P3D: Final = "processing.opengl.PGraphics3D"
OPENGL: Final = P3D
FX2D: Final = "processing.javafx.PGraphicsFX2D"
PDF: Final = "processing.pdf.PGraphicsPDF"
SVG: Final = "processing.svg.PGraphicsSVG"

# Numbers
EPSILON: Final = 0.0001
MAX_FLOAT: Final = 3.4028234663852886e38
MIN_FLOAT: Final = -MAX_FLOAT
MAX_INT: Final = 2**31 - 1
MIN_INT: Final = -(2**31)
PI: Final = math.pi
HALF_PI: Final = math.pi / 2
THIRD_PI: Final = math.pi / 3
QUARTER_PI: Final = math.pi / 4
TWO_PI: Final = math.tau
TAU: Final = math.tau
DEG_TO_RAD: Final = math.pi / 180
RAD_TO_DEG: Final = 180 / math.pi
X: Final = 0
Y: Final = 1
Z: Final = 2

# Colour models and image formats
RGB: Final = 1
ARGB: Final = 2
HSB: Final = 3
ALPHA: Final = 4

# Filters
BLUR: Final = 11
GRAY: Final = 12
INVERT: Final = 13
OPAQUE: Final = 14
POSTERIZE: Final = 15
THRESHOLD: Final = 16
ERODE: Final = 17
DILATE: Final = 18

# Blend modes
REPLACE: Final = 0
BLEND: Final = 1 << 0
ADD: Final = 1 << 1
SUBTRACT: Final = 1 << 2
LIGHTEST: Final = 1 << 3
DARKEST: Final = 1 << 4
DIFFERENCE: Final = 1 << 5
EXCLUSION: Final = 1 << 6
MULTIPLY: Final = 1 << 7
SCREEN: Final = 1 << 8
OVERLAY: Final = 1 << 9
HARD_LIGHT: Final = 1 << 10
SOFT_LIGHT: Final = 1 << 11
DODGE: Final = 1 << 12
BURN: Final = 1 << 13

# Kinds of projection
CUSTOM: Final = 0
ORTHOGRAPHIC: Final = 2
PERSPECTIVE: Final = 3

# Shapes
GROUP: Final = 0
POINT: Final = 2
POINTS: Final = 3
LINE: Final = 4
LINES: Final = 5
LINE_STRIP: Final = 50
LINE_LOOP: Final = 51
TRIANGLE: Final = 8
TRIANGLES: Final = 9
TRIANGLE_STRIP: Final = 10
TRIANGLE_FAN: Final = 11
QUAD: Final = 16
QUADS: Final = 17
QUAD_STRIP: Final = 18
POLYGON: Final = 20
PATH: Final = 21
RECT: Final = 30
ELLIPSE: Final = 31
ARC: Final = 32
SPHERE: Final = 40
BOX: Final = 41
OPEN: Final = 1
CLOSE: Final = 2
CHORD: Final = 2
PIE: Final = 3

# Codes of a shape's vertices
VERTEX: Final = 0
BEZIER_VERTEX: Final = 1
QUADRATIC_VERTEX: Final = 2
CURVE_VERTEX: Final = 3
BREAK: Final = 4

# How numbers are read, and where things are aligned
CORNER: Final = 0
CORNERS: Final = 1
RADIUS: Final = 2
CENTER: Final = 3
DIAMETER: Final = 3
BASELINE: Final = 0
TOP: Final = 101
BOTTOM: Final = 102

# Textures and text
NORMAL: Final = 1
IMAGE: Final = 2
CLAMP: Final = 0
REPEAT: Final = 1
MODEL: Final = 4
SHAPE: Final = 5
NEAREST_NEIGHBOR: Final = 0
BILINEAR: Final = 1
BICUBIC: Final = 2

# Strokes
SQUARE: Final = 1 << 0
ROUND: Final = 1 << 1
PROJECT: Final = 1 << 2
MITER: Final = 1 << 3
BEVEL: Final = 1 << 5

# Keys: the first six are characters, the others key codes
BACKSPACE: Final = "\b"
TAB: Final = "\t"
ENTER: Final = "\n"
RETURN: Final = "\r"
ESC: Final = "\x1b"
DELETE: Final = "\x7f"
CODED: Final = "\uffff"
SHIFT: Final = 16
CONTROL: Final = 17
ALT: Final = 18
LEFT: Final = 37
UP: Final = 38
RIGHT: Final = 39
DOWN: Final = 40

# The pointer's shapes
ARROW: Final = 0
CROSS: Final = 1
TEXT: Final = 2
WAIT: Final = 3
HAND: Final = 12
MOVE: Final = 13

# Windows
PORTRAIT: Final = 1
LANDSCAPE: Final = 2
SPAN: Final = 0

# Hints: DISABLE and ENABLE of one thing differ in sign
ENABLE_NATIVE_FONTS: Final = 1
DISABLE_NATIVE_FONTS: Final = -1
DISABLE_DEPTH_TEST: Final = 2
ENABLE_DEPTH_TEST: Final = -2
ENABLE_DEPTH_SORT: Final = 3
DISABLE_DEPTH_SORT: Final = -3
DISABLE_OPENGL_ERRORS: Final = 4
ENABLE_OPENGL_ERRORS: Final = -4
DISABLE_DEPTH_MASK: Final = 5
ENABLE_DEPTH_MASK: Final = -5
DISABLE_OPTIMIZED_STROKE: Final = 6
ENABLE_OPTIMIZED_STROKE: Final = -6
ENABLE_STROKE_PERSPECTIVE: Final = 7
DISABLE_STROKE_PERSPECTIVE: Final = -7
DISABLE_TEXTURE_MIPMAPS: Final = 8
ENABLE_TEXTURE_MIPMAPS: Final = -8
ENABLE_STROKE_PURE: Final = 9
DISABLE_STROKE_PURE: Final = -9
ENABLE_BUFFER_READING: Final = 10
DISABLE_BUFFER_READING: Final = -10
DISABLE_KEY_REPEAT: Final = 11
ENABLE_KEY_REPEAT: Final = -11
DISABLE_ASYNC_SAVEFRAME: Final = 12
ENABLE_ASYNC_SAVEFRAME: Final = -12
