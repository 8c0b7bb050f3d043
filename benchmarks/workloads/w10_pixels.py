"""W10: every pixel of the window set anew, as an array."""

import numpy as np


def setup():
    global columns, rows
    size(640, 480, P2D)
    columns = np.arange(640)[None]
    rows = np.arange(480)[:, None]


def draw():
    loadPixels()
    np_pixels[..., 0] = (columns + frameCount) & 255
    np_pixels[..., 1] = rows & 255
    np_pixels[..., 2] = 128
    np_pixels[..., 3] = 255
    updatePixels()
