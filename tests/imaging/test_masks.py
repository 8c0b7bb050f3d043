import numpy as np

from sketchkit.imaging.masks import luminances


def test_alpha_is_how_bright_the_mask_is():
    # From Processing: 0.2126 * 100 + 0.7152 * 100 + 0.0722 * 50 = 96.4, and so on.
    mask = np.array([[[100, 100, 50, 255], [0, 100, 50, 0], [190, 100, 50, 255]]], np.uint8)

    assert luminances(mask).tolist() == [[96, 75, 116]]
