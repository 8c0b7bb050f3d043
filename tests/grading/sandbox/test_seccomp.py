"""The filter of system calls, interpreted as the kernel does it: for both processors, on any."""

from __future__ import annotations

import errno
import platform
from collections.abc import Callable

import pytest

from sketchkit.grading.sandbox import kernel, seccomp
from sketchkit.grading.sandbox.seccomp import ALLOW, KILL, REFUSE

OWN_PID = 7
Judge = Callable[..., int]


@pytest.fixture(params=["x86_64", "aarch64"])
def judge(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Judge:
    """Return what answers a call: by name or number, with arguments."""
    monkeypatch.setattr(platform, "machine", lambda: request.param)
    program = seccomp.program(OWN_PID)

    def answer(call: str | int, *arguments: int, architecture: int | None = None) -> int:
        number = kernel.number(call) if isinstance(call, str) else call
        assert number is not None
        return interpreted(
            program, number, architecture or kernel.ARCHITECTURES[request.param], arguments
        )

    return answer


def interpreted(
    program: list[seccomp.Instruction], number: int, architecture: int, arguments: tuple[int, ...]
) -> int:
    """Run classic BPF: the five operations that the filter is made of."""
    seen = {0: number, 4: architecture}
    seen |= {16 + 8 * n: value & 0xFFFFFFFF for n, value in enumerate(arguments)}
    at, loaded = 0, 0
    while True:
        operation, if_true, if_false, value = program[at]
        at += 1
        match operation:
            case 0x20:
                loaded = seen.get(value, 0)
            case 0x06:
                return value
            case 0x15 | 0x25 | 0x45:
                is_so = {0x15: loaded == value, 0x25: loaded > value, 0x45: loaded & value != 0}
                at += if_true if is_so[operation] else if_false
            case _:
                raise AssertionError(operation)


def test_what_is_on_the_list_is_refused(judge: Judge) -> None:
    there = [name for name in seccomp.REFUSED if kernel.number(name) is not None]

    assert {name: judge(name) for name in there} == dict.fromkeys(there, REFUSE + errno.EPERM)
    assert len(there) > 90


@pytest.mark.parametrize("name", seccomp.ABSENT)
def test_what_programs_can_do_without_is_not_there(judge: Judge, name: str) -> None:
    assert judge(name) == REFUSE + errno.ENOSYS


@pytest.mark.parametrize("number", [463, 500, 0x40000000 + 39, 0xFFFFFFFF])
def test_newer_calls_and_other_tables_are_not_there(judge: Judge, number: int) -> None:
    assert judge(number) == REFUSE + errno.ENOSYS


def test_another_processors_table_ends_the_process(judge: Judge) -> None:
    assert judge(20, architecture=0x40000003) == KILL  # i386


@pytest.mark.parametrize(
    ("call", "arguments", "expected"),
    [
        ("clone", (0x10F00,), ALLOW),  # what a thread is made with, among others CLONE_THREAD
        ("clone", (17,), REFUSE + errno.EPERM),  # SIGCHLD: a process
        ("clone", (0x10000011 & ~0x10000,), REFUSE + errno.EPERM),
        ("kill", (OWN_PID, 6), ALLOW),
        ("kill", (1, 0), REFUSE + errno.EPERM),
        ("kill", (-1, 0), REFUSE + errno.EPERM),
        ("tgkill", (OWN_PID, 8, 6), ALLOW),
        ("tgkill", (1, 1, 9), REFUSE + errno.EPERM),
        ("prlimit64", (0, 7), ALLOW),
        ("prlimit64", (OWN_PID, 7), ALLOW),
        ("prlimit64", (1, 7), REFUSE + errno.EPERM),
        ("ioctl", (0, 0x5401), ALLOW),
        ("ioctl", (0, 0x5412), REFUSE + errno.ENOTTY),
        ("fcntl", (0, 1), ALLOW),
        ("fcntl", (0, 8), REFUSE + errno.EPERM),
        ("prctl", (15,), ALLOW),
        ("prctl", (1,), REFUSE + errno.EPERM),
    ],
)
def test_arguments_decide(
    judge: Judge, call: str, arguments: tuple[int, ...], expected: int
) -> None:
    assert judge(call, *arguments) == expected


def test_reading_is_allowed(judge: Judge) -> None:
    read = {"x86_64": 0, "aarch64": 63}[platform.machine()]

    assert judge(read, 3) == ALLOW


def test_no_number_stands_for_two_calls(judge: Judge) -> None:
    numbers = [kernel.number(name) for name in kernel.NUMBERS]
    there = [number for number in numbers if number is not None]

    assert len(there) == len(set(there))


def test_jumps_stay_within_a_filters_reach(judge: Judge) -> None:
    program = seccomp.program(OWN_PID)

    assert len(program) < 4096
    assert max(max(one[1], one[2]) for one in program) < 256
