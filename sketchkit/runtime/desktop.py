"""The rest of the desktop, for a sketch in a window: browser, other programs, file dialogs."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import webbrowser
from collections.abc import Callable, Sequence

from sketchkit.core.notices import warn_once

# Run by a Python of its own: Tk and GLFW do not share a process on every system.
DIALOG = """
import sys
from pathlib import Path
from tkinter import Tk, filedialog
kind, prompt, start = sys.argv[1:]
root = Tk()
root.withdraw()
path = Path(start)
folder, name = (start, "") if path.is_dir() else (str(path.parent), path.name)
if kind == "folder":
    chosen = filedialog.askdirectory(title=prompt, initialdir=folder)
elif kind == "input":
    chosen = filedialog.askopenfilename(title=prompt, initialdir=folder, initialfile=name)
else:
    chosen = filedialog.asksaveasfilename(title=prompt, initialdir=folder, initialfile=name)
sys.stdout.reconfigure(encoding="utf-8")
print(chosen or "", end="")
"""


def open_link(url: str) -> None:
    """Show a page in the browser."""
    if not webbrowser.open(url):
        warn_once(f"link() has found no browser to show {url}.")


def launch(arguments: Sequence[str]) -> None:
    """Open a file with the program that belongs to it; several arguments are a program's call."""
    command = list(arguments) if len(arguments) > 1 else _opener(arguments[0])
    try:
        subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    except OSError:
        warn_once(f"launch() has found no program {command[0]} on this computer.")


def choose_file(kind: str, prompt: str, start: str, then: Callable[[str | None], None]) -> None:
    """Show a dialog beside the sketch, and hand over what was chosen when it is closed.

    Parameters
    ----------
    kind : str
        `"input"`, `"output"` or `"folder"`.
    prompt, start : str
        What stands above it, and where it begins.
    then : callable
        Called, in a thread of its own, with the path; with None if nothing was chosen.
    """
    if not can_show_dialogs():
        warn_once("There are no dialogs for files here: they need tkinter, a package of Python's.")
        then(None)
        return
    command = [sys.executable, "-c", DIALOG, kind, prompt, start]

    def ask() -> None:
        answer = subprocess.run(command, capture_output=True, check=False)
        then(answer.stdout.decode("utf-8") or None)

    threading.Thread(target=ask, daemon=True).start()


def can_show_dialogs() -> bool:
    """Tell whether Python has its toolkit for windows: some systems leave it out."""
    try:
        import tkinter  # noqa: F401 # is all that is asked
    except ImportError:
        return False
    return True


def _opener(what: str) -> list[str]:
    """Return the call that opens a file or an address as a double click would."""
    if sys.platform == "darwin":
        return ["open", what]
    if os.name == "nt":
        return ["cmd", "/c", "start", "", what]
    return ["xdg-open", what]
