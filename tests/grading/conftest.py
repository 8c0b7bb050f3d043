"""What the tests of grading share: the walls of this computer."""

from __future__ import annotations

import shutil
import subprocess

import pytest

from sketchkit.grading.sandbox import kernel
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.probe import probe

# Bubblewrap by itself, as its own manual calls it: what it cannot do here, we cannot either.
NAMESPACES = ("bwrap", "--unshare-all", "--ro-bind", "/", "/", "--proc", "/proc", "true")


@pytest.fixture(scope="session")
def walled() -> Level:
    """Return this computer's level. Whatever the computer has to offer has to hold."""
    if shutil.which("bwrap") is None:
        pytest.skip("bubblewrap is not installed: bash install.sh does that")
    plain = subprocess.run(NAMESPACES, capture_output=True, text=True, check=False)
    if plain.returncode != 0:
        pytest.skip(f"bubblewrap can do nothing on this computer: {plain.stderr.strip()}")
    level = probe()
    walls = (level.bubblewrap, level.seccomp, level.limits, level.landlock or not has_landlock())
    assert all(walls), f"{level.in_words}. {level.remedy} {level.missing}"
    return level


def has_landlock() -> bool:
    """Return whether the kernel knows Landlock."""
    ask_for_version = 1
    try:
        return kernel.call("landlock_create_ruleset", None, 0, ask_for_version) > 0
    except OSError:
        return False
