"""What the class hands in, and what each is to get."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from textwrap import dedent

from sketchkit.grading.results import Status
from tests.grading.class_of_sixty.assignment import REFERENCE

ALL = (10.0, 10.0)
NONE = (0.0, 0.0)
ENDED = (Status.STOPPED, Status.CRASHED)
ANY = tuple(Status)


@dataclass(frozen=True)
class Case:
    """A submission and its verdict.

    Attributes
    ----------
    name : str
    text : str
        Of its sketch.
    marks : (lowest, highest)
    status : sequence of Status
        Those that may befall it.
    said : str
        What its result says somewhere.
    """

    name: str
    text: str
    marks: tuple[float, float]
    status: Sequence[Status] = (Status.GRADED,)
    said: str = ""


def right(name: str, *changes: tuple[str, str]) -> str:
    """Return the right sketch, with changes."""
    text = REFERENCE.partition("\n")[2]
    for old, new in changes:
        assert old in text, (name, old)
        text = text.replace(old, new)
    return text


def case(
    name: str,
    *changes: tuple[str, str],
    marks: tuple[float, float],
    status: Sequence[Status] = (Status.GRADED,),
    said: str = "",
) -> Case:
    return Case(name, right(name, *changes), marks, status, said)


def good_and(name: str, line: str, **wishes: object) -> Case:
    """Return the right sketch, which does something else as well in its second frame."""
    text = right(name) + "    if frameCount == 2:\n        attack()\n\n"
    text += "def attack():\n" + "".join(f"    {one}\n" for one in dedent(line).strip().split("\n"))
    return Case(name, text, **{"marks": ALL, **wishes})  # type: ignore[arg-type] # a Case's own


def only(name: str, text: str, **wishes: object) -> Case:
    wishes = {"marks": NONE, "status": ANY, **wishes}
    return Case(name, dedent(text), **wishes)  # type: ignore[arg-type] # a Case's own


RIGHT = [
    Case("Right", right("Right"), ALL),
    case(
        "Right, push and pop",
        (
            "with pushMatrix():\n        translate(45",
            "if True:\n        push()\n        translate(45",
        ),
        ("        box(30)\n", "        box(30)\n        pop()\n"),
        marks=ALL,
    ),
    case("Zoë Ångström 李雷", ("angle = frameCount * 0.1", "angle += 0.1"), marks=ALL),
    case("By a function " + "x" * 90, ("box(30)", "box(30, 30, 30)"), marks=ALL),
]
SLIGHTLY_WRONG = [
    case("A box too small", ("box(30)", "box(26)"), marks=(4, 9.5)),
    case("A rect missing", ("    rect(0, 0, 12, 6)\n", ""), marks=(3, 9)),
    case("A box missing", ("        box(40, 30, 30)\n", "        pass\n"), marks=(1, 8)),
    case("A colour off", ("fill(60, 200, 90)", "fill(90, 200, 60)"), marks=(4, 9.5)),
    case("Moved by six", ("translate(45, 40, 20)", "translate(51, 40, 20)"), marks=(4, 9)),
    case("Turns too fast", ("frameCount * 0.1", "frameCount * 0.13"), marks=(2, 9)),
    case("A pixel aside", ("translate(65, 50, -15)", "translate(66, 50, -15)"), marks=(6, 9.5)),
    case("Slightly another colour", ("fill(220, 120, 40)", "fill(226, 120, 40)"), marks=(4, 9.5)),
    case("Hard edges", ("    noStroke()", "    noStroke(); noSmooth()"), marks=(4, 10)),
]

WRONG_BY_NAME = [
    case(
        "Flipped",
        ("    lights()\n", "    lights()\n    scale(1, -1)\n    translate(0, -90)\n"),
        marks=(2, 9),
    ),
    case(
        "Flipped, and red and blue",
        ("    lights()\n", "    lights()\n    scale(1, -1)\n    translate(0, -90)\n"),
        ("background(30, 40, 60)", "background(60, 40, 30)"),
        ("fill(220, 120, 40)", "fill(40, 120, 220)"),
        ("fill(60, 200, 90)", "fill(90, 200, 60)"),
        ("fill(240, 240, 0)", "fill(0, 240, 240)"),
        marks=(2, 8),
    ),
    case(
        "Red and blue",
        ("background(30, 40, 60)", "background(60, 40, 30)"),
        ("fill(220, 120, 40)", "fill(40, 120, 220)"),
        ("fill(60, 200, 90)", "fill(90, 200, 60)"),
        ("fill(240, 240, 0)", "fill(0, 240, 240)"),
        marks=(3, 8),
        said="red and blue",
    ),
    case("No lights", ("    lights()\n", ""), marks=(2, 8), said="lights"),
    case(
        "No depth",
        ("    noStroke()", "    noStroke()\n    hint(DISABLE_DEPTH_TEST)"),
        marks=(3, 9.5),
        said="depth",
    ),
    case("Another frame", ("frameCount * 0.1", "(frameCount + 1) * 0.1"), marks=(2, 9)),
    case(
        "Another size", ("size(120, 90, P3D)", "size(200, 90, P3D)"), marks=(2, 8), said="200 x 90"
    ),
]
BROKEN = [
    only("Empty", ""),
    only("Not Python", "void setup() {\n  size(120, 90, P3D);\n}\n", said="Not Python.py, line 1"),
    only("A name misspelt", "def setup():\n    siez(9, 9)\n", said="Do you mean size"),
    case("Stops at frame 15", ("    angle = f", "    if frameCount == 15: 1 / 0\n    angle = f"),
         marks=(5, 9), status=(Status.STOPPED,), said="before frame 20"),
    only("Recursion", "def draw():\n    draw()\n", status=ENDED),
    only("Segmentation fault", "import ctypes\nctypes.string_at(0)\n", status=ENDED),
    only("Abort", "import os\nos.abort()\n", status=ENDED),
    only("Leaves", "import sys\ndef setup():\n    sys.exit('bye')\n", said="bye"),
    only("Hangs in draw", "def draw():\n    while True: pass\n", status=(Status.OVER_LIMIT,),
         said="and was stopped"),
    only("Sleeps", "import time\ndef setup():\n    time.sleep(999)\n", status=(Status.OVER_LIMIT,),
         said="12 s"),
    only("Much memory", "def setup():\n    global a\n    a = bytearray(1 << 40)\n", status=ENDED),
    only("Ever more memory", "a = []\ndef draw():\n    while True: a.append(bytearray(1 << 26))\n",
         status=(Status.OVER_LIMIT, *ENDED)),
    only("Huge canvas", "def setup():\n    size(60000, 60000, P3D)\n"),
    only("Draws without end", """
        def draw():
            for i in range(10 ** 9):
                rect(i % 90, 3, 9, 9)
        """, status=(Status.OVER_LIMIT, *ENDED)),
    only("Prints without end", "def draw():\n    while True: print('x' * 10000)\n",
         status=(Status.OVER_LIMIT,)),
]  # fmt: skip # a table

# Whoever draws what is asked for has earned it, whatever else was tried in vain.
HOSTILE = [
    good_and("Fork bomb", """
        import os
        for _ in range(10000):
            try: os.fork()
            except OSError: pass
        """),
    good_and("Starts a shell", """
        import subprocess
        try: subprocess.run(["sh", "-c", "echo owned"], check=False)
        except OSError: print("no")
        """),
    good_and("Kills the parent", """
        import os, signal
        for pid in [os.getppid(), 1, -1]:
            try: os.kill(pid, signal.SIGKILL)
            except OSError: pass
        """, marks=(0, 10), status=ANY),
    good_and("Threads", """
        import threading, time
        for _ in range(5000):
            try: threading.Thread(target=time.sleep, args=(99,), daemon=True).start()
            except RuntimeError: break
        """, marks=(0, 10), status=ANY),
    good_and("Fills the disk", """
        try:
            for i in range(10000):
                open(f"big{i}", "wb").write(bytes(1 << 24))
        except OSError: pass
        """, marks=(0, 10), status=ANY),
    good_and("Many files", """
        try:
            for i in range(100000): open(f"f{i}", "w").close()
        except OSError: pass
        """),
    good_and("Writes outside", """
        import os
        for place in ["/", "/usr", "/submission", "/etc", "/tmp", os.path.expanduser("~")]:
            try: open(os.path.join(place, "owned-by-a-sketch"), "w").write("x")
            except OSError: pass
        """),
    good_and("Looks for the reference", """
        import os
        for top, folders, files in os.walk("/"):
            folders[:] = [f for f in folders if f not in ("proc", "sys", "usr", "lib", "lib64")]
            for name in files:
                path = os.path.join(top, name)
                try: text = open(path, "rb").read(1 << 20)
                except OSError: continue
                if b"8f2d6c" in text and b"SELF" not in text: print("FOUND", path)
        """),
    good_and("Reads the environment", """
        import os
        print("ENVIRONMENT", sorted(os.environ))
        print("SECRET", os.environ.get("SKETCHKIT_TEST_SECRET"))
        """),
    good_and("Network", """
        import socket
        try:
            s = socket.socket(); s.settimeout(1); s.connect(("127.0.0.1", 80)); print("CONNECTED")
        except OSError: pass
        """),
    good_and("Looks at processes", """
        import os
        pids = [p for p in os.listdir("/proc") if p.isdigit()]
        print("PROCESSES", len(pids))
        for pid in pids:
            try: print("CMD", open(f"/proc/{pid}/cmdline").read()[:200])
            except OSError: pass
        """, marks=(0, 10)),
    good_and("Forged words", """
        import json, os, struct
        head = json.dumps(["told", {"mistake": "", "end": 20, "damage": ""}]).encode()
        for fd in range(3, 20):
            try: os.write(fd, struct.pack("<IQ", len(head), 0) + head)
            except OSError: pass
        """, marks=(0, 10), status=ANY),
    only("Good frame, then gone", right("g") + "    if frameCount == 1: rest()\n\n"
         "def rest():\n    import os\n    os._exit(0)\n", marks=(0, 4), status=(Status.CRASHED,)),
    only("Forged pictures", """
        import os
        def draw():
            for folder in (".", "/tmp", "/out", "/sketch", "out"):
                try:
                    os.makedirs(folder, exist_ok=True)
                    for n in (1, 10, 20):
                        open(f"{folder}/frame-{n:04}.png", "wb").write(b"\\x89PNG")
                except OSError: pass
        """),
    only("Forged report", """
        import json
        def draw():
            for name in ("results.json", "result.json", "/tmp/results.json", "outcome.json"):
                try: open(name, "w").write(json.dumps({"score": 10, "points": 10}))
                except OSError: pass
        """),
    only("Patches the grader", """
        import sys
        def patch(*args, **kwargs): return 1.0
        for name, module in list(sys.modules.items()):
            if name.startswith("sketchkit.grading"):
                for key in list(vars(module)):
                    if callable(getattr(module, key)): setattr(module, key, patch)
        import sketchkit.draw.renderer as renderer
        renderer.Renderer.stats = property(lambda self: renderer.Stats(0, 0))
        """, marks=(0, 0)),
    only("Claims boxes and lights", """
        import sketchkit.tape.recorders as r
        old = r.encode_recorder
        def forged(recorder, encoder):
            recorder.nestings[:] = [9] * len(recorder.nestings)
            return old(recorder, encoder)
        r.encode_recorder = forged
        import sketchkit.tape.writing as w
        w.encode_recorder = forged
        def draw():
            rect(1, 1, 9, 9)
        """, marks=(0, 1)),
    only("Claims the angle", """
        angle = 0
        def draw():
            global angle
            angle = frameCount * 0.1
        """, marks=(1, 1)),
    only("Text in a comment", "# box(30) lights()\ndef draw():\n    'box(1); lights()'\n"),
    only("Imports the grader", """
        from sketchkit.grading.assignment.load import load
        from pathlib import Path
        for place in ("/", "/submission", "/assignment", "..", "../.."):
            try: print("LOADED", load(Path(place)).title)
            except Exception as e: print(type(e).__name__)
        """),
    good_and("Memory in pipes", """
        import fcntl, os
        pipes = []
        try:
            while True:
                reader, writer = os.pipe()
                pipes.append(writer)
                os.set_blocking(writer, False)
                fcntl.fcntl(writer, 1031, 1 << 20)
                os.write(writer, bytes(1 << 20))
        except OSError: pass
        for writer in pipes: os.close(writer)
        """),
    good_and("Threads and wishes that stay", """
        import atexit, sys, threading, time
        threading.Thread(target=time.sleep, args=(999,)).start()
        atexit.register(time.sleep, 999)
        sys.settrace(lambda *about: None)
        sys.excepthook = sys.stdout = sys.stderr = None
        """),
    good_and("The output's words forged", """
        import json
        json.dumps = lambda *about, **more: '["end", 20]'
        """, marks=(0, 5)),
    good_and("Reads of the kernel", """
        for name in ("kcore", "keys", "1/mem", "kallsyms", "sched_debug", "kmsg"):
            try: print("KERNEL", name, len(open("/proc/" + name, "rb").read(99)))
            except OSError: pass
        """),
    only("=cmd|' C calc'!A0;=1+1", "print('=1+1')\n"),
    good_and("HTML", """
        print("<script>document.title='owned'</script><img src=x onerror=alert(1)>")
        print("</pre></textarea><b>'\\"&amp;")
        """),
    only("HTML <b>in a name", "print('</script>')\nraise Exception('<script>owned()</script>')\n",
         status=(Status.STOPPED,)),
    good_and("Terminal codes", r"""
        print("\x1b[2J\x1b]0;owned\x07\x00\u202e")
        """),
    good_and("Closes everything", """
        import os
        os.closerange(0, 256)
        """, marks=(0, 10), status=ANY),
    good_and("Truncates the tape", """
        import os
        try: os.ftruncate(3, 0)
        except OSError: pass
        """, marks=(0, 10), status=ANY),
    good_and("Garbage on the tape", """
        import os
        os.write(3, os.urandom(100000))
        """, marks=(0, 5), status=(Status.CRASHED,)),
    good_and("Stops itself", """
        import os, signal
        os.kill(os.getpid(), signal.SIGSTOP)
        """, marks=(0, 10), status=ANY),
    good_and("Ignores signals", """
        import signal
        for number in range(1, 60):
            try: signal.signal(number, signal.SIG_IGN)
            except (OSError, ValueError): pass
        while True: pass
        """, marks=(0, 5), status=(Status.OVER_LIMIT,)),
    good_and("Traces and mounts", """
        import ctypes, os
        libc = ctypes.CDLL(None, use_errno=True)
        for number in (101, 165, 272, 308, 425, 250, 298, 321):
            libc.syscall(number, 0, 0, 0, 0, 0)
        """, marks=(0, 10), status=ANY),
    good_and("A link to the outside", """
        import os
        for target in ("/etc/shadow", "/proc/1/root", "/proc/1/environ", "/root"):
            try:
                os.symlink(target, "link"); print("LINKED", open("link").read()[:50])
            except OSError: pass
            finally:
                try: os.unlink("link")
                except OSError: pass
        """),
    case("Not the same twice",
         ("rect(0, 0, 12, 6)", "import time; rect(0, 0, 12, 6 + time.time_ns() % 7)"),
         marks=(0, 10)),
]  # fmt: skip # a table

CASES = [*RIGHT, *SLIGHTLY_WRONG, *WRONG_BY_NAME, *BROKEN, *HOSTILE]
