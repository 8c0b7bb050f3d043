"""Expected numbers were measured with Processing."""

import pytest

from sketchkit.core.errors import SketchError
from tests.api.sketches import new_sketch


@pytest.fixture
def chance():
    return new_sketch()


def test_random_and_gaussian_follow_the_seed(chance):
    chance.randomSeed(42)

    numbers = [chance.random(100), chance.random(-5, 5), chance.randomGaussian()]

    assert numbers == pytest.approx([72.756371, -4.4533482, 1.1027445])


def test_random_without_a_range_is_below_one(chance):
    assert chance.random() == pytest.approx(0.73096776)


def test_random_of_a_list_is_one_of_its_values(chance):
    drawn = {chance.random(["a", "b", "c"]) for _ in range(50)}

    assert drawn == {"a", "b", "c"}


def test_random_of_an_empty_list_is_told(chance):
    with pytest.raises(SketchError, match="something in it"):
        chance.random([])


@pytest.mark.parametrize("args", [(None,), (1, "2"), ({},)], ids=str)
def test_random_of_something_else_is_told(chance, args):
    with pytest.raises(SketchError, match=r"^random\(\) takes"):
        chance.random(*args)


def test_noise_follows_the_seed(chance):
    chance.noiseSeed(0)

    assert chance.noise(0.5) == pytest.approx(0.66836804, abs=1e-6)
    assert chance.noise(1.5, 2.5) == pytest.approx(0.36199683, abs=1e-6)


def test_noise_detail_of_one_octave_is_at_most_a_half(chance):
    chance.noiseDetail(1)

    assert max(chance.noise(x / 10) for x in range(500)) <= 0.5


@pytest.mark.parametrize("name", ["random", "randomSeed", "noiseSeed", "noiseDetail", "noise"])
def test_text_is_no_number(chance, name):
    with pytest.raises(SketchError, match=rf"^{name}\(\) takes"):
        getattr(chance, name)("text")


def test_choice_is_random_without_its_fraction(chance):
    numbers = [chance.random(6), chance.random(-9, 9)]
    chance.randomSeed(0)

    assert [chance.choice(6), chance.choice(-9, 9)] == [int(number) for number in numbers]


def test_choice_takes_one_of_a_list(chance):
    assert chance.choice(["a", "b", "c", "d"]) == "c"  # random(4) is 2.9


@pytest.mark.parametrize(("args", "words"), [(([],), "has something in it"), (("abc",), "choice")])
def test_choice_of_nothing_is_told(chance, args, words):
    with pytest.raises(SketchError, match=words):
        chance.choice(*args)
