import math
from types import SimpleNamespace

import numpy as np
import pytest

from sketchkit.runtime.watching import is_watchable, number_at


class Broken:
    @property
    def x(self) -> float:
        raise RuntimeError("no")


NAMESPACE: dict[str, object] = {
    "angle": 1.5,
    "ball": SimpleNamespace(x=3, place=SimpleNamespace(y=np.float32(0.25))),
    "balls": [SimpleNamespace(x=7)],
    "table": {"speed": 9, 2: 4},
    "is_on": True,
    "name": "Ann",
    "broken": Broken(),
}


@pytest.mark.parametrize(
    ("path", "number"),
    [
        ("angle", 1.5),
        ("ball.x", 3.0),
        ("ball.place.y", 0.25),
        ("balls[0].x", 7.0),
        ("balls[-1].x", 7.0),
        ("table['speed']", 9.0),
        ('table["speed"]', 9.0),
        ("table[2]", 4.0),
        ("is_on", 1.0),
    ],
)
def test_number_is_found_by_its_name(path: str, number: float) -> None:
    assert is_watchable(path)
    assert number_at(path, NAMESPACE) == number


@pytest.mark.parametrize("path", ["nothing", "ball.z", "balls[3]", "name", "ball", "broken.x"])
def test_what_is_no_number_is_nan(path: str) -> None:
    assert math.isnan(number_at(path, NAMESPACE))


@pytest.mark.parametrize("path", ["", "f()", "a + b", "a.", "a[", "a[b]", "1a", "a b", ".x"])
def test_what_is_no_name_cannot_be_watched(path: str) -> None:
    assert not is_watchable(path)
