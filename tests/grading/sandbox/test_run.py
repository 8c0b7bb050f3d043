"""Jobs that go on without end, or take all there is; and what the grader has afterwards."""

from __future__ import annotations

import platform
import subprocess
import sys
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

from sketchkit.grading.sandbox.job import MEGABYTE, Exceeded, Job, SandboxError
from sketchkit.grading.sandbox.level import Level
from sketchkit.grading.sandbox.run import run
from tests.grading.sandbox.conftest import SHORT, Attack, attacked, running

SAY = """
import json, os
from sketchkit.grading.sandbox import inside
def say(found):
    os.write(inside.OUTPUT, json.dumps(found).encode())
"""
# The job tells it itself: what the parent of a process is told has the parent's own peak in it.
PEAK_KB = "resource.getrusage(resource.RUSAGE_SELF).ru_maxrss"
BRIEF = replace(SHORT, wall_s=1.5)
FOREVER = "import time\nwhile True: time.sleep(9)"


# --- time -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "code",
    [
        "while True: pass",
        "import signal\nsignal.signal(signal.SIGXCPU, signal.SIG_IGN)\nwhile True: pass",
        "import re\nre.match('(a+)+$', 'a' * 64 + 'b')",
        "10 ** 10 ** 10",
    ],
    ids=["loop", "ignores the signal", "regular expression", "large number"],
)
def test_processor_time_is_bounded(attack: Attack, code: str) -> None:
    result = attack(code, replace(SHORT, cpu_s=1))

    assert result.ending.exceeded is Exceeded.CPU
    assert result.ending.cpu_s < 4
    assert result.ending.sentence() == "It needed more than 1 s of processor time and was stopped."


@pytest.mark.parametrize(
    "code",
    [
        FOREVER,
        "import os\nos.closerange(0, 256)\n" + FOREVER,
        "import os, signal\nos.kill(os.getpid(), signal.SIGSTOP)\n" + FOREVER,
        "import signal\nsignal.pthread_sigmask(signal.SIG_BLOCK, range(1, 65))\n" + FOREVER,
        "import signal\nsignal.signal(signal.SIGTERM, signal.SIG_IGN)\n" + FOREVER,
        "import os, threading\nthreading.Thread(target=threading.Event().wait).start()",
        "import os\nr, w = os.pipe()\nos.read(r, 1)",
        "import os\nos.dup2(3, 1)\nos.dup2(1, 2)\n" + FOREVER,
    ],
    ids=[
        *("sleeps", "closes all it has", "stops itself", "blocks signals", "ignores SIGTERM"),
        *("waits for a thread", "waits for itself", "duplicates descriptors"),
    ],
)
def test_time_is_bounded(attack: Attack, code: str) -> None:
    result = attack(code, BRIEF)

    assert result.ending.exceeded is Exceeded.WALL
    assert result.ending.sentence() == "It was not done after 1.5 s and was stopped."


# --- printing -------------------------------------------------------------------------------


def test_printing_without_end_is_stopped(attack: Attack) -> None:
    result = attack("while True: print('x' * 9999)")

    assert result.ending.exceeded is Exceeded.CONSOLE
    assert len(result.ending.console) < SHORT.console_kb * 1024 + 99


def test_printing_much_is_cut_off_and_says_so(attack: Attack) -> None:
    result = attack("print('a' * 64 * 1024 + 'b' * 2048)")

    assert result.ending.went_well
    assert result.ending.console.startswith("a" * 64 * 1024 + "\n[It printed more: 3 kB")


def test_both_streams_are_kept_in_order(attack: Attack) -> None:
    result = attack("import sys\nprint('one', flush=True)\nprint('two', file=sys.stderr)")

    assert result.ending.console.startswith("one\ntwo\n")


def test_what_is_printed_may_be_no_text(attack: Attack) -> None:
    result = attack("import os\nos.write(1, b'\\xff\\x00\\n')")

    assert result.ending.console.startswith("\ufffd\x00\n")


# --- memory ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "code",
    [
        "kept = []\nwhile True: kept.append(bytearray(1 << 24))",
        "bytearray(1 << 40)",
        "x = 'x'\nwhile True: x += x",
        "import mmap\nkept = []\nwhile True: kept.append(mmap.mmap(-1, 1 << 26))",
    ],
    ids=["a list grows", "one huge piece", "a text doubles", "mappings"],
)
def test_memory_is_bounded(attack: Attack, code: str) -> None:
    measured = f"{SAY}\nimport resource\ntry:\n    exec({code!r})\nfinally:\n    say({PEAK_KB})"

    result = attack(measured, replace(SHORT, memory_mb=512))

    assert result.ending.exceeded is Exceeded.MEMORY
    assert result.said < 512 * 1024
    assert "512 MB of memory" in result.ending.sentence()


def test_pipes_hold_little(attack: Attack) -> None:
    code = """
import fcntl, os
held = 0
try:
    while True:
        r, w = os.pipe()
        os.set_blocking(w, False)
        try: fcntl.fcntl(w, 1031, 1 << 20)
        except OSError: pass
        try: held += os.write(w, bytes(1 << 20))
        except BlockingIOError: pass
except OSError:
    say(held)
"""
    assert attack(SAY + code).said <= 128 * MEGABYTE


# --- output and files -----------------------------------------------------------------------


@pytest.mark.parametrize(
    "code",
    [
        "import os\nwhile True: os.write(3, bytes(1 << 16))",
        "import os\ntry: os.write(3, bytes(1 << 26))\nfinally: os._exit(0)",
    ],
    ids=["without end", "at once, and ends well"],
)
def test_output_is_bounded(attack: Attack, code: str) -> None:
    result = attack(code)

    assert result.ending.exceeded is Exceeded.OUTPUT
    assert len(result.output) == SHORT.output_mb * MEGABYTE
    assert "2 MB" in result.ending.sentence()


def test_output_cannot_be_made_long_and_hollow(attack: Attack) -> None:
    result = attack("import os\nos.ftruncate(3, 1 << 40)")

    assert "File too large" in result.ending.console
    assert result.output == b""


def test_output_can_only_be_added_to(attack: Attack) -> None:
    result = attack("import os\nos.write(3, b'abc')\nos.lseek(3, 0, 0)\nos.write(3, b'd')")

    assert result.output == b"abcd"


def test_output_stays_readable(attack: Attack) -> None:
    result = attack("import os\nos.write(3, b'abc')\nos.fchmod(3, 0)")

    assert result.output == b"abc"


def test_output_takes_the_place_of_a_link_and_follows_none(attack: Attack, tmp_path: Path) -> None:
    precious = tmp_path / "precious"
    precious.write_text("kept")
    (tmp_path / "output").symlink_to(precious)

    result = attack("import os\nos.write(3, b'abc')")

    assert precious.read_text() == "kept"
    assert result.output == b"abc"
    assert not result.output_file.is_symlink()


@pytest.mark.parametrize("folder", ["/sketch", "/tmp"])
def test_a_folder_holds_so_much_and_no_more(attack: Attack, folder: str) -> None:
    code = f"""
written = 0
try:
    for number in range(999):
        with open(f"{folder}/{{number}}", "wb", buffering=0) as file:
            for _ in range(16): written += file.write(bytes(1 << 16))
except OSError:
    say(written)
"""
    assert attack(SAY + code).said <= SHORT.scratch_mb * MEGABYTE


def test_a_file_without_substance_is_no_way_round(attack: Attack) -> None:
    code = "with open('/sketch/hollow', 'wb') as file: file.truncate(1 << 30)"

    assert "File too large" in attack(code).ending.console


@pytest.mark.parametrize("folder", ["/sketch", "/tmp"])
@pytest.mark.parametrize("make", ["open(name, 'w').close()", "os.mkdir(name)"])
def test_a_folder_holds_so_many_files_and_no_more(attack: Attack, folder: str, make: str) -> None:
    code = f"""
count = 0
try:
    while True:
        name = f"{folder}/{{count}}"
        {make}
        count += 1
except OSError:
    say(count)
"""
    assert attack(SAY + code).said <= SHORT.scratch_files


def test_folders_within_folders_without_end(attack: Attack) -> None:
    code = """
depth = 0
try:
    while True:
        os.mkdir("a")
        os.chdir("a")
        depth += 1
except OSError:
    say(depth)
"""
    assert attack(SAY + code).said <= SHORT.scratch_files


# --- processes and threads ------------------------------------------------------------------


def test_threads_are_bounded(attack: Attack) -> None:
    code = """
import threading
threading.stack_size(65536)
wait = threading.Event()
count = 0
try:
    while True:
        threading.Thread(target=wait.wait, daemon=True).start()
        count += 1
except RuntimeError:
    say(count)
    os._exit(0)
"""
    assert SHORT.threads <= attack(SAY + code).said <= SHORT.threads + 4


def test_forking_without_end_does_not_begin(attack: Attack) -> None:
    result = attack("import os\nwhile True: os.fork()")

    assert "PermissionError" in result.ending.console


# --- endings --------------------------------------------------------------------------------


def test_leaving_early_says_how(attack: Attack) -> None:
    result = attack("import os\nos._exit(0)")

    assert result.ending.went_well
    assert result.output == b""


@pytest.mark.parametrize(
    ("code", "status", "signal", "words"),
    [
        ("import os; os._exit(3)", 3, None, "exit status 3"),
        ("import ctypes; ctypes.string_at(0)", None, 11, "SIGSEGV"),
        ("import os; os.abort()", None, 11, "gave up"),  # signal 6 cannot end a first process
        ("1 / 0", 1, None, "exit status 1"),
    ],
    ids=["exit", "segmentation fault", "abort", "error"],
)
def test_an_ending_is_told(
    attack: Attack, code: str, status: int | None, signal: int | None, words: str
) -> None:
    ending = attack(code).ending

    assert (ending.code, ending.signal) == (status, signal)
    assert ending.exceeded is None
    assert words in ending.sentence()


@pytest.mark.skipif(platform.machine() != "x86_64", reason="a table that only x86 has")
def test_the_32_bit_table_of_system_calls_ends_the_process(attack: Attack) -> None:
    code = """
import ctypes, mmap
page = mmap.mmap(-1, 4096, prot=7)
page.write(b"\\xb8\\x14\\x00\\x00\\x00\\xcd\\x80\\xc3")  # mov eax, 20 (getpid); int 0x80; ret
ctypes.CFUNCTYPE(ctypes.c_int)(ctypes.addressof(ctypes.c_char.from_buffer(page)))()
"""
    assert attack(code).ending.signal in (11, 31)  # SIGSYS, or a kernel without that table


def test_deep_recursion_is_the_submissions_own_matter(attack: Attack) -> None:
    code = """
import sys
sys.setrecursionlimit(10 ** 9)
def f(): return [*map(lambda _: f(), [0])]
f()
"""

    ending = attack(code, replace(SHORT, memory_mb=512)).ending

    assert ending.code != 0


# --- the grader -----------------------------------------------------------------------------


def test_jobs_run_side_by_side(walled: Level, tmp_path: Path) -> None:
    def one(number: int) -> str:
        folder = tmp_path / str(number)
        folder.mkdir()
        code = f"import os, time\nopen('/sketch/mine', 'x')\nos.write(3, b'{number}')"
        return attacked(folder, walled, code).output.decode()

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(one, range(8))) == [str(number) for number in range(8)]


def test_nothing_outlives_a_grader_that_is_killed(walled: Level, tmp_path: Path) -> None:
    output = tmp_path / "output"
    mark = f"mark-{tmp_path.name}-{time.monotonic_ns()}"
    grader = f"""
from pathlib import Path
from sketchkit.grading.sandbox.job import Job
from sketchkit.grading.sandbox.probe import probe
from sketchkit.grading.sandbox.run import run
statement = "import os, time; os.write(3, b'up')\\nwhile True: time.sleep(9) # {mark}"
run(Job("timeit", ("-n1", "-r1", statement), output=Path({str(output)!r})), probe())
"""
    process = subprocess.Popen([sys.executable, "-c", grader])
    waited_for(lambda: output.exists() and output.read_bytes() == b"up")
    assert len(running(mark)) >= 3  # the grader, bubblewrap, and the job

    process.kill()
    process.wait()

    waited_for(lambda: running(mark) == [])


def waited_for(is_so: object, limit_s: float = 20) -> None:
    """Wait until something is so; fail if it does not come about."""
    assert callable(is_so)
    end = time.monotonic() + limit_s
    while not is_so():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_an_interrupted_grader_leaves_nothing(
    walled: Level, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mark = f"mark-{time.monotonic_ns()}"

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("sketchkit.grading.sandbox.watch._exceeded", interrupt)
    statement = f"import time\nwhile True: time.sleep(9) # {mark}"

    with pytest.raises(KeyboardInterrupt):
        run(Job("timeit", ("-n", "1", "-r", "1", statement)), walled)

    assert running(mark) == []


def test_a_job_finds_what_it_is_given(attack: Attack, tmp_path: Path) -> None:
    tape = tmp_path / "tape"
    tape.write_text("recorded")
    tape.chmod(0o644)

    assert attack(SAY + "say(inside.path('/tape').read_text())", tape=tape).said == "recorded"


def test_a_file_that_is_not_there_is_told(walled: Level, tmp_path: Path) -> None:
    job = Job("timeit", readable={"/tape": tmp_path / "missing"})

    with pytest.raises(SandboxError, match="missing: No such file"):
        run(job, walled)


def test_folders_can_be_hidden(walled: Level, tmp_path: Path) -> None:
    hidden = Path(unittest.__file__).parent  # among Python's own, and not needed
    code = f"import os; print(os.listdir({str(hidden)!r}))"

    ending = run(Job("timeit", ("-n", "1", "-r", "1", code), hidden=(hidden,)), walled)

    assert "PermissionError" in ending.console


@pytest.mark.parametrize("backend", ["gl", "cpu"])
def test_sketches_are_drawn_inside(attack: Attack, backend: str) -> None:
    code = f"""
from pathlib import Path
from sketchkit.runtime.backends import open_backend
from sketchkit.runtime.headless import Launch, render
sketch = Path("/sketch/sketch.py")
sketch.write_text('''
def setup():
    size(100, 100, P3D)

def draw():
    background(0, 0, 255)
    noStroke()
    fill(255, 0, 0)
    translate(50, 50)
    box(40)
''')
(frame,) = render(Launch(sketch, print), [1], open_backend({backend!r}).backend)
say([frame.pixels[50, 50].tolist(), frame.pixels[5, 5].tolist()])
"""
    limits = replace(SHORT, cpu_s=60, wall_s=120)

    assert attack(SAY + code, limits).said == [[255, 0, 0], [0, 0, 255]]
