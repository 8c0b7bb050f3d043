from __future__ import annotations

import pytest

from sketchkit.grading.sandbox import bare, bubblewrap
from sketchkit.grading.sandbox.job import SandboxError
from sketchkit.grading.sandbox.level import Level, Strength, require
from sketchkit.grading.sandbox.probe import probe

FULL = Level(bubblewrap=True, seccomp=True, landlock=True, limits=True)


@pytest.mark.parametrize(
    ("level", "in_words"),
    [
        (FULL, "full: bubblewrap, seccomp, Landlock and rlimits"),
        (
            Level(seccomp=True, limits=True),
            "partial: seccomp and rlimits; without bubblewrap and Landlock",
        ),
        (
            Level(limits=True),
            "limits only: rlimits; without bubblewrap, seccomp and Landlock",
        ),
        (Level(), "none: a submission can do what you can"),
    ],
    ids=["full", "partial", "limits", "none"],
)
def test_a_level_says_what_it_has_and_what_not(level: Level, in_words: str) -> None:
    assert level.in_words == in_words
    assert level.in_words.startswith(level.name)


def test_only_a_full_level_needs_no_remedy() -> None:
    assert FULL.remedy == ""
    assert "bubblewrap" in Level(seccomp=True).remedy
    assert "kernel" in Level(bubblewrap=True, limits=True).remedy


@pytest.mark.parametrize("wanted", list(Strength))
def test_a_level_is_enough_for_itself_and_less(wanted: Strength) -> None:
    require(FULL, wanted)


def test_less_than_is_required_is_refused_with_a_remedy() -> None:
    with pytest.raises(SandboxError, match="asked to be 'full', but here it is partial"):
        require(Level(seccomp=True, limits=True), Strength.FULL)


def test_a_level_that_runs_nothing_is_refused_whatever_is_required() -> None:
    with pytest.raises(SandboxError, match="as root"):
        require(Level(refusal="Not as root."), Strength.NONE)


def test_root_without_bubblewrap_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bubblewrap, "program", lambda: None)
    monkeypatch.setattr(bare, "is_root", lambda: True)

    level = probe.__wrapped__()

    assert "not run as root" in level.refusal
    assert level.name == "none"


def test_without_bubblewrap_the_other_walls_are_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bubblewrap, "program", lambda: None)
    monkeypatch.setattr(bare, "is_root", lambda: False)

    level = probe.__wrapped__()

    assert not level.bubblewrap
    assert level.limits
    assert level.missing[-1] == "Bubblewrap is not installed."


def test_a_bubblewrap_that_fails_is_not_counted_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bubblewrap, "program", lambda: "/bin/false")
    monkeypatch.setattr(bare, "is_root", lambda: False)

    level = probe.__wrapped__()

    assert not level.bubblewrap
    assert "Bubblewrap was tried" in level.missing[-1]
