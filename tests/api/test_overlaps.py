from pathlib import Path

import pytest

from sketchkit.api.overlaps import Overlap, opener, overlaps


class Canvas:
    def __init__(self) -> None:
        self.calls: list[tuple[object, ...]] = []

    def set(self, x: float, y: float, color: int) -> None:
        self.calls.append(("set", x, y, color))

    def filter(self, kind: int, level: float = 1) -> None:
        self.calls.append(("filter", kind, level))


@pytest.mark.parametrize(
    ("name", "args"), [("set", (1, 2, 0xFF000000)), ("filter", (11, 6)), ("filter", (12,))]
)
def test_arguments_of_processing_go_to_the_canvas(name: str, args: tuple[int, ...]) -> None:
    canvas = Canvas()
    overlap = overlaps(canvas)[name]
    assert isinstance(overlap, Overlap)

    overlap(*args)

    assert canvas.calls[0][: len(args) + 1] == (name, *args)


def test_set_is_pythons_for_all_else() -> None:
    both = overlaps(Canvas())["set"]
    assert isinstance(both, Overlap)

    assert (both(), both([1, 1]), both("ab")) == (set(), {1}, {"a", "b"})
    assert isinstance({1}, both)  # type: ignore[arg-type] # what is tested
    assert both.union({1}, {2}) == {1, 2}  # type: ignore[operator] # as above
    assert both[int] == set[int]


def test_filter_is_pythons_for_functions() -> None:
    both = overlaps(Canvas())["filter"]
    assert isinstance(both, Overlap)

    assert list(both(None, [0, 1])) == [1]  # type: ignore[call-overload] # what is tested
    assert list(both(str.isalpha, "a1")) == ["a"]  # type: ignore[call-overload] # as above


def test_set_can_be_the_base_of_a_class() -> None:
    both = overlaps(Canvas())["set"]

    kind = type("Flowers", both.__mro_entries__(()), {})  # type: ignore[attr-defined] # as class does

    assert kind(["rose"]) == {"rose"}


def test_subclass_of_set_calls_its_init_by_name() -> None:
    both = overlaps(Canvas())["set"]
    flowers: set[str] = set()

    both.__init__(flowers, ["rose"])  # type: ignore[misc,call-arg] # as a class does

    assert flowers == {"rose"}


def test_open_looks_into_data(tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "a.txt").write_text("hello")

    with opener(tmp_path)("a.txt") as file:  # type: ignore[attr-defined] # a file
        assert file.read() == "hello"
