"""Expected numbers were measured with Processing's random() and randomGaussian()."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sketchkit.core.errors import SketchError
from sketchkit.core.rng import JavaRandom


@pytest.mark.parametrize(
    ("seed", "expected"),
    [
        (0, [0.7309677600860596, 0.8314409852027893, 0.2405363917350769]),
        (42, [0.7275636792182922, 0.054665207862854004, 0.6832234263420105]),
        (-7, [0.26912176609039307, 0.9014975428581238, 0.6731811761856079]),
        (2**40 + 5, [0.1563010811805725, 0.5867583155632019, 0.7952896356582642]),
    ],
    ids=str,
)
def test_a_seed_gives_processings_numbers(seed, expected):
    generator = JavaRandom(seed)

    assert [generator.below(1) for _ in range(3)] == expected


def test_all_kinds_of_numbers_come_from_one_stream():
    generator = JavaRandom(42)
    for _ in range(5):
        generator.below(1)

    numbers = [generator.between(10, 20) for _ in range(3)]
    numbers += [generator.gaussian() for _ in range(5)]
    numbers += [generator.below(0.1), generator.below(0.1), generator.below(0.1)]
    numbers += [generator.between(-5, 5) for _ in range(3)]
    numbers += [generator.below(-5), generator.below(100), generator.below(1000000)]

    assert numbers == [
        *(19.420734405517578, 12.770784378051758, 17.077106475830078),
        *(0.28097763657569885, 0.6846228241920471, -0.8172214031219482),
        *(-1.3966434001922607, -0.19094450771808624),
        *(0.09193277359008789, 0.015195823274552822, 0.0436490960419178),
        *(-0.6020021438598633, 2.499061107635498, 4.30631160736084),
        *(-1.9328341484069824, 79.82865905761719, 177378.46875),
    ]


def test_seeding_again_starts_over():
    generator = JavaRandom(5)
    first = [generator.below(1), generator.gaussian()]

    generator.seed(5)

    assert [generator.below(1), generator.gaussian()] == first


def test_double_has_53_random_bits():
    assert JavaRandom(0).next_double() == 0.730967787376657  # Java's new Random(0).nextDouble()


@pytest.mark.parametrize(("low", "high"), [(5, 5), (7, 2)], ids=["equal", "reversed"])
def test_low_is_the_result_when_it_is_not_below_high(low, high):
    assert JavaRandom(0).between(low, high) == low


def test_below_zero_is_zero():
    assert JavaRandom(0).below(0) == 0


@given(st.integers(0, 2**48), st.floats(1e-3, 1e6))
def test_below_stays_below(seed, high):
    assert 0 <= JavaRandom(seed).below(high) < high * (1 + 1e-7)


@pytest.mark.parametrize("high", [float("inf"), float("nan")], ids=str)
def test_a_limit_that_is_not_finite_is_refused(high):
    with pytest.raises(SketchError, match="finite"):
        JavaRandom(0).below(high)
