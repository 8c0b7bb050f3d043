"""The example that instructors read: it loads, its page names every key, its sketch draws."""

import re
from pathlib import Path

import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.grading.assignment.load import load
from sketchkit.grading.assignment.plan import runs
from sketchkit.grading.assignment.references import sketch_of
from sketchkit.grading.assignment.starter import ASSIGNMENT
from sketchkit.grading.checks.kinds import KINDS
from sketchkit.runtime.headless import Launch, render

FOLDER = Path(__file__).parents[3] / "sketches" / "grading"
EXAMPLE = FOLDER / "spinning_box"
PAGE = (FOLDER / "README.md").read_text(encoding="utf-8")


def refuse(path: Path, line: int, text: str) -> None:
    raise AssertionError(f"{path.name}, line {line}: {text}")


def test_it_loads_and_has_each_kind() -> None:
    assert [check.kind for check in load(EXAMPLE).checks] == [
        "image",
        "sequence",
        "interaction",
        "motion",
        "trace",
        "source",
        "performance",
    ]


def test_it_needs_a_run_with_events_and_one_without() -> None:
    assert [run.events for run in runs(load(EXAMPLE))] == ["", "events.json"]


def test_its_reference_draws_an_orange_box() -> None:
    sketch = sketch_of(EXAMPLE / "reference")
    assert sketch is not None

    (frame,) = render(Launch(sketch, refuse), (1,), CpuBackend())

    red, green, blue = frame.pixels[120, 160].tolist()
    assert red > green > blue
    assert frame.pixels[5, 5].tolist() == [255, 255, 255]


@pytest.mark.parametrize("kind", KINDS)
def test_page_has_a_part_for_each_kind(kind: str) -> None:
    assert re.search(rf"^### `{kind}`: ", PAGE, re.MULTILINE)


def keys_of(text: str) -> set[str]:
    return set(re.findall(r"^(?:# )?(\w+) = ", text, re.MULTILINE))


@pytest.mark.parametrize(
    "key", sorted(keys_of(ASSIGNMENT) | keys_of((EXAMPLE / "assignment.toml").read_text()))
)
def test_page_names_each_key_that_is_used(key: str) -> None:
    assert re.search(rf"`{key}`", PAGE)
