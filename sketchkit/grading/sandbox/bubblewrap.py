"""The outer wall, on Linux: bubblewrap's namespaces.

A job sees a file system put together for it: the system and Python read-only, what it was given,
and two empty folders of bounded size. It has no network, sees no other process, and runs as a
user who owns nothing.
"""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import select
import shutil
import signal
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from sketchkit.grading.sandbox.channels import Channels, plan_of
from sketchkit.grading.sandbox.job import MEGABYTE, Job, SandboxError
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.plan import NOBODY, Plan
from sketchkit.grading.sandbox.surroundings import (
    SETTINGS,
    SYSTEM,
    command,
    environment,
    python_places,
)
from sketchkit.grading.sandbox.watch import PATIENCE_S, Running

OWN = ("/sketch", "/tmp")
DEVICES = ("null", "zero", "full", "random", "urandom")
USERS = b"root:x:0:0::/:/bin/false\nsketch:x:65534:65534::/tmp:/bin/false\n"
# What it needs to get ready; start.py gives them up before anything else is run.
CAPABILITIES = ("CAP_SYS_ADMIN", "CAP_SETUID", "CAP_SETGID")
# Users above all that systems hand out, to containers too (those end at 1879048191).
FIRST_SPARE_USER, SPARE_USERS = 1_900_000_000, 1 << 24


def program() -> str | None:
    """Return where bubblewrap is installed, if it is."""
    return shutil.which("bwrap")


@contextlib.contextmanager
def started(job: Job, level: Level, channels: Channels) -> Iterator[Running]:
    """Start a job behind the wall, and see to it that none of it is left at the end.

    Raises
    ------
    SandboxError
        If the wall could not be put up.
    """
    names = (*job.readable, *OWN)
    plan = replace(
        plan_of(job, channels),
        paths={name: name for name in names},
        readable=("/",),
        own=OWN,
        is_walled=True,
        has_seccomp=level.seccomp,
        has_landlock=level.landlock,
        is_trial=level.is_trial,
    )
    process, first = _spawn(job, plan, channels)
    running = Running(process, lambda: _kill(first))
    try:
        yield running
    finally:
        running.end()
        select.select([first], [], [], PATIENCE_S)  # until the kernel has ended all within
        os.close(first)
        running.reap()


def _kill(first: int) -> None:
    with contextlib.suppress(ProcessLookupError):
        signal.pidfd_send_signal(first, signal.SIGKILL)


def _spawn(job: Job, plan: Plan, channels: Channels) -> tuple[subprocess.Popen[bytes], int]:
    """Start bubblewrap; return its process, and a hold on the first one within (a pidfd).

    When that one ends, the kernel ends all others within.
    """
    told, tell = os.pipe()
    wait, let_go = os.pipe()
    handed = [tell, wait, _holding(USERS)]
    try:
        handed.append(_holding(_separated(_arguments(job, *handed))))
        process = subprocess.Popen(
            [program() or "bwrap", "--args", str(handed[-1]), *command(job)],
            stdin=subprocess.DEVNULL,
            stdout=channels.console,
            stderr=channels.console,
            pass_fds=(*handed, *channels.passed()),
            env=environment(plan),
            cwd="/",
        )
    finally:
        for one in handed:
            os.close(one)
    try:
        return process, _let_go(told, let_go)
    except BaseException:
        process.kill()
        process.wait()
        raise
    finally:
        os.close(told)
        os.close(let_go)


def _let_go(told: int, let_go: int) -> int:
    """Give the waiting process its users, and let it go on; return a hold on it."""
    answer = b""
    while b"}" not in answer:
        part = os.read(told, 4096)
        if not part:
            raise SandboxError("Bubblewrap ended before it had begun.")
        answer += part
    pid = json.loads(answer)["child-pid"]
    first = os.pidfd_open(pid)
    try:
        _map_users(Path("/proc", str(pid)))
        os.write(let_go, b"1")
    except OSError as reason:
        os.close(first)
        raise SandboxError(f"The namespace got no users: {reason}.") from None
    return first


def _map_users(process: Path) -> None:
    """Say who the users within are outside.

    An ordinary user can only be himself, under another number. Root, who must not be root within,
    has a user made up for each job: one with no files and no other processes, so that limits on
    the number of processes hold, which never bind root.
    """
    spare = FIRST_SPARE_USER + secrets.randbelow(SPARE_USERS)
    if has_spare_users():
        users = groups = f"0 0 1\n{NOBODY} {spare} 1\n"
    else:
        (process / "setgroups").write_text("deny")
        users, groups = f"{NOBODY} {os.getuid()} 1\n", f"{NOBODY} {os.getgid()} 1\n"
    (process / "uid_map").write_text(users)
    (process / "gid_map").write_text(groups)


def has_spare_users() -> bool:
    """Return whether this process is root, and may be any user it likes."""
    if os.getuid() != 0:
        return False
    return all(_covers_spare(Path("/proc/self", name)) for name in ("uid_map", "gid_map"))


def _covers_spare(map_of_ids: Path) -> bool:
    lines = map_of_ids.read_text().splitlines()
    ranges = [[int(number) for number in line.split()] for line in lines]
    last = FIRST_SPARE_USER + SPARE_USERS
    return any(first <= FIRST_SPARE_USER and last < first + count for first, _, count in ranges)


def _arguments(job: Job, tell: int, wait: int, users: int) -> Iterator[str]:
    first_user = "0" if has_spare_users() else str(NOBODY)
    yield from ("--unshare-user", "--unshare-pid", "--unshare-net", "--unshare-ipc")
    yield from ("--unshare-uts", "--unshare-cgroup-try", "--hostname", "sketch")
    yield from ("--uid", first_user, "--gid", first_user)
    yield from ("--info-fd", str(tell), "--userns-block-fd", str(wait))
    # As the first process its times are bubblewrap's children's, which we can be told.
    yield from ("--as-pid-1", "--die-with-parent", "--new-session")
    yield from ("--cap-drop", "ALL")
    for capability in CAPABILITIES:
        yield from ("--cap-add", capability)
    yield from _system(users)
    for folder in OWN:  # first, since Python may lie below /tmp
        size = str(job.limits.scratch_mb * MEGABYTE)
        yield from ("--perms", "1777", "--size", size, "--tmpfs", folder)
    for place in python_places():
        yield from _shown(place.resolve(), place)
    for place in job.hidden:
        yield from _covered(place.resolve())
    for name, place in job.readable.items():
        yield from _shown(place.resolve(), Path(name))
    yield from ("--remount-ro", "/", "--chdir", "/sketch")


def _system(users: int) -> Iterator[str]:
    """Yield what shows the system: programs and libraries, a few settings, a few devices."""
    for place in map(Path, SYSTEM):
        if place.is_symlink():
            yield from ("--symlink", str(place.readlink()), str(place))
        else:
            yield from ("--ro-bind-try", str(place), str(place))
    yield from ("--perms", "0755", "--dir", "/etc")
    for name in SETTINGS:
        yield from ("--ro-bind-try", f"/etc/{name}", f"/etc/{name}")
    yield from ("--perms", "0644", "--file", str(users), "/etc/passwd")
    yield from ("--proc", "/proc")
    yield from ("--size", "65536", "--tmpfs", "/dev")
    for name in DEVICES:
        yield from ("--dev-bind", f"/dev/{name}", f"/dev/{name}")
    yield from ("--remount-ro", "/dev")


def _shown(source: Path, place: Path) -> Iterator[str]:
    """Yield what shows a file or folder, in folders that may be passed through.

    Bubblewrap would close them to others if they are closed outside, as /root is.
    """
    for folder in reversed(place.parents[:-1]):
        if str(folder) in OWN:
            continue
        yield from ("--perms", "0755", "--dir", str(folder))
    yield from ("--ro-bind", str(source), str(place))


def _covered(place: Path) -> Iterator[str]:
    """Yield what hides a folder, if it lies in one that is shown."""
    shown = [Path(name).resolve() for name in SYSTEM] + [one.resolve() for one in python_places()]
    if any(place.is_relative_to(other) for other in shown):
        yield from ("--perms", "0000", "--size", "4096", "--tmpfs", str(place))
        yield from ("--remount-ro", str(place))


def _separated(arguments: Iterator[str]) -> bytes:
    """Return arguments as bubblewrap reads them from a file: no list of processes shows them."""
    return b"".join(os.fsencode(argument) + b"\0" for argument in arguments)


def _holding(data: bytes) -> int:
    """Return a file descriptor from which data can be read."""
    file = os.memfd_create("sandbox")
    os.write(file, data)
    os.lseek(file, 0, os.SEEK_SET)
    return file
