"""Landlock: the kernel's own list of the files that a process may still reach."""

from __future__ import annotations

import ctypes
import os
import struct
from collections.abc import Iterable
from pathlib import Path

from sketchkit.grading.sandbox import kernel

EXECUTE, WRITE_FILE, READ_FILE, READ_DIR = 1 << 0, 1 << 1, 1 << 2, 1 << 3
REMOVE_DIR, REMOVE_FILE, MAKE_DIR, MAKE_REG = 1 << 4, 1 << 5, 1 << 7, 1 << 8
REFER, TRUNCATE = 1 << 13, 1 << 14
# How many rights over files each version of Landlock knows; version 1 is Linux 5.13.
RIGHTS_BY_VERSION = {1: 13, 2: 14, 3: 15, 4: 15, 5: 16}
NETWORK_SINCE, SCOPES_SINCE = 4, 6
BIND_AND_CONNECT_TCP = 0b11
ABSTRACT_SOCKETS_AND_SIGNALS = 0b11

READING = READ_FILE | READ_DIR
OWN_FOLDER = (
    READING | WRITE_FILE | REMOVE_DIR | REMOVE_FILE | MAKE_DIR | MAKE_REG | REFER | TRUNCATE
)
A_FILE = WRITE_FILE | READ_FILE | TRUNCATE  # the rights that can be given over a single file
PATH_BENEATH = 1  # the kind of rule


def restrict(readable: Iterable[Path], own: Iterable[Path], devices: Iterable[Path]) -> None:
    """Confine this thread, and all that it starts, for good.

    Parameters
    ----------
    readable : iterable of Path
        Files, and folders with all they hold, that may be read.
    own : iterable of Path
        Folders in which files may be made, changed and removed. Links may not, nor devices.
    devices : iterable of Path
        Files that may be read and written.

    Raises
    ------
    OSError
        If the kernel has no Landlock.
    """
    if not kernel.is_known():
        raise OSError("no table of system calls for this system")
    ask_for_version = 1
    version = kernel.call("landlock_create_ruleset", None, 0, ask_for_version)
    handled = (1 << RIGHTS_BY_VERSION[min(version, max(RIGHTS_BY_VERSION))]) - 1
    network = BIND_AND_CONNECT_TCP if version >= NETWORK_SINCE else 0
    scopes = ABSTRACT_SOCKETS_AND_SIGNALS if version >= SCOPES_SINCE else 0
    attributes = ctypes.create_string_buffer(struct.pack("=QQQ", handled, network, scopes), 24)
    rules = kernel.call("landlock_create_ruleset", attributes, _size(version), 0)
    try:
        for paths, rights in ((readable, READING), (own, OWN_FOLDER), (devices, A_FILE)):
            for path in paths:
                _allow(rules, path, rights & handled)
        kernel.prctl(kernel.PR_SET_NO_NEW_PRIVS, 1)
        kernel.call("landlock_restrict_self", rules, 0)
    finally:
        os.close(rules)


def _size(version: int) -> int:
    """Return how many bytes of attributes a version knows: it refuses more."""
    return 8 if version < NETWORK_SINCE else 16 if version < SCOPES_SINCE else 24


def _allow(rules: int, path: Path, rights: int) -> None:
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except FileNotFoundError:
        return  # what is not there needs no permission
    try:
        if not path.is_dir():
            rights &= A_FILE
        rule = ctypes.create_string_buffer(struct.pack("=Qi", rights, place), 12)
        kernel.call("landlock_add_rule", rules, PATH_BENEATH, rule, 0)
    finally:
        os.close(place)
