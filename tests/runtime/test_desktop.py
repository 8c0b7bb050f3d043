import subprocess
import sys
import threading

import pytest

from sketchkit.core.notices import SketchWarning
from sketchkit.runtime import desktop


def test_link_without_a_browser_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(desktop.webbrowser, "open", lambda url: False)

    with pytest.warns(SketchWarning, match="found no browser"):
        desktop.open_link("https://processing.org")


def test_program_that_is_missing_is_told() -> None:
    with pytest.warns(SketchWarning, match="found no program surely-not-there"):
        desktop.launch(["surely-not-there", "x"])


@pytest.mark.parametrize(
    ("platform", "name", "opener"),
    [
        ("linux", "posix", ["xdg-open", "a.txt"]),
        ("darwin", "posix", ["open", "a.txt"]),
        ("win32", "nt", ["cmd", "/c", "start", "", "a.txt"]),
    ],
)
def test_single_file_is_opened_as_the_system_does(
    monkeypatch: pytest.MonkeyPatch, platform: str, name: str, opener: list[str]
) -> None:
    called = []
    monkeypatch.setattr(desktop.sys, "platform", platform)
    monkeypatch.setattr(desktop.os, "name", name)
    monkeypatch.setattr(desktop.subprocess, "Popen", lambda command, **_: called.append(command))

    desktop.launch(["a.txt"])

    assert called == [opener]


@pytest.mark.parametrize(("answer", "expected"), [(b"/m\xc3\xbcsic", "/müsic"), (b"", None)])
def test_what_the_dialog_prints_is_handed_over(
    monkeypatch: pytest.MonkeyPatch, answer: bytes, expected: str | None
) -> None:
    calls, chosen, is_closed = [], [], threading.Event()

    def run(command: list[str], **_: object) -> subprocess.CompletedProcess[bytes]:
        calls.append(command)
        return subprocess.CompletedProcess(command, 0, stdout=answer)

    def then(path: str | None) -> None:
        chosen.append(path)
        is_closed.set()

    monkeypatch.setattr(desktop, "can_show_dialogs", lambda: True)
    monkeypatch.setattr(desktop.subprocess, "run", run)

    desktop.choose_file("input", "Which?", "/home", then)

    assert is_closed.wait(10)
    assert chosen == [expected]
    assert calls == [[sys.executable, "-c", desktop.DIALOG, "input", "Which?", "/home"]]


def test_without_a_toolkit_nothing_is_chosen(monkeypatch: pytest.MonkeyPatch) -> None:
    chosen = []
    monkeypatch.setattr(desktop, "can_show_dialogs", lambda: False)

    with pytest.warns(SketchWarning, match="need tkinter"):
        desktop.choose_file("input", "Which?", "/home", chosen.append)

    assert chosen == [None]


def test_dialog_is_a_program_that_python_can_read() -> None:
    compile(desktop.DIALOG, "dialog", "exec")
