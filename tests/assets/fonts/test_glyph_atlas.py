import numpy as np

from sketchkit.assets.fonts.glyph_atlas import FIRST_HEIGHT, SIDE, GlyphAtlas, Letter, Place
from sketchkit.core.style import Typeface


def letter(character):
    return Letter(Typeface(), 12, True, character, 0, 0)


def mask(width, height, value=200):
    return np.full((height, width), value, np.uint8)


def test_masks_lie_side_by_side_with_a_gap():
    atlas = GlyphAtlas()

    places = [atlas.place(letter("a"), mask(5, 8)), atlas.place(letter("b"), mask(3, 4))]

    assert places == [Place(0, 1, 1), Place(0, 8, 1)]


def test_a_mask_is_the_alpha_of_white():
    atlas = GlyphAtlas()

    atlas.place(letter("a"), mask(5, 8, 90))

    assert atlas.image(0).data[1, 1].tolist() == [255, 255, 255, 90]
    assert atlas.image(0).data[0, 0].tolist() == [255, 255, 255, 0]  # the gap
    assert atlas.image(0).data[10, 0].tolist() == [0, 0, 0, 0]  # unused


def test_a_known_letter_keeps_its_place_and_changes_nothing():
    atlas = GlyphAtlas()
    first = atlas.place(letter("a"), mask(5, 8))
    version = atlas.image(0).version

    assert atlas.place(letter("a"), mask(5, 8)) == first
    assert atlas.image(0).version == version


def test_a_full_row_is_followed_by_one_below():
    atlas = GlyphAtlas()
    atlas.place(letter("a"), mask(1000, 10))

    assert atlas.place(letter("b"), mask(30, 5)) == Place(0, 1, 13)


def test_growing_makes_a_new_image_and_leaves_the_old_one():
    atlas = GlyphAtlas()
    first = atlas.place(letter("a"), mask(1000, 200))
    old = atlas.image(0)

    atlas.place(letter("b"), mask(1000, 100))

    assert old.height == FIRST_HEIGHT  # 202 rows are in use
    assert atlas.image(0).height == 2 * FIRST_HEIGHT
    assert atlas.growths == 1
    assert atlas.place(letter("a"), mask(1000, 200)) == first
    assert (atlas.image(0).data[:202] == old.data[:202]).all()


def test_a_square_image_that_is_full_is_followed_by_another():
    atlas = GlyphAtlas()

    places = [atlas.place(letter(str(i)), mask(1000, 300)) for i in range(4)]

    assert [place.image for place in places] == [0, 0, 0, 1]
    assert atlas.image(0).height == SIDE
    assert places[3][1:] == (1, 1)


def test_large_letters_begin_with_a_higher_image():
    assert GlyphAtlas(512).image(0).height == 512


def test_an_image_knows_its_letters():
    atlas = GlyphAtlas()

    atlas.place(letter("a"), mask(5, 8))

    assert atlas.image(0).letters == {(1, 1): letter("a")}
