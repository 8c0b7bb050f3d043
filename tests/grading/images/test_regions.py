import numpy as np

from sketchkit.grading.images.regions import largest_region


def test_nothing_is_no_region() -> None:
    assert largest_region(np.zeros((4, 5), bool)) is None


def test_largest_is_found_with_its_box() -> None:
    different = np.zeros((20, 30), bool)
    different[2:5, 3:7] = True  # 12
    different[10:16, 20:22] = True  # 12, and
    different[16, 22] = True  # one at its corner

    region = largest_region(different)

    assert region
    assert region.size == 13
    assert region.box == (20, 10, 3, 7)
    assert region.others == 1
    assert region.pixels.sum() == 13
    assert not region.pixels[0, 2]


def test_all_of_a_picture_is_one_region() -> None:
    region = largest_region(np.ones((1, 1), bool))

    assert region
    assert (region.size, region.box, region.others) == (1, (0, 0, 1, 1), 0)
