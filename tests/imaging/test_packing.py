import numpy as np

from sketchkit.imaging.packing import to_argb, to_rgba


def test_alpha_is_the_highest_byte():
    assert to_argb(np.array([0xCC, 0x66, 0x00, 0x80], np.uint8)) == 0x80CC6600


def test_packing_and_unpacking_are_inverse():
    data = np.random.default_rng(0).integers(0, 256, (4, 5, 4), np.uint8)

    assert (to_rgba(to_argb(data)) == data).all()
