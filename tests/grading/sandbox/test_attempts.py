"""What a submission may try, and what comes of it. All are tried in one job, each for itself."""

from __future__ import annotations

import json
import os
import socket
from pathlib import Path
from typing import Any

import pytest

from sketchkit.grading.sandbox.level import Level
from tests.grading.sandbox.conftest import attacked

# Each is a function's body; what it returns or raises is what is found out.
ATTEMPTS = {
    # other processes
    "fork": "return os.fork()",
    "spawn": "return os.posix_spawn('/usr/bin/true', ['true'], {})",
    "subprocess": "return subprocess.run(['/usr/bin/true'])",
    "exec": "return os.execv('/usr/bin/true', ['true'])",
    "clone": "return call(56 if x86 else 220, 17, 0, 0, 0, 0)",  # SIGCHLD: a process
    "clone3": "return call(435, 0, 0)",
    "clone_with_namespace": "return call(56 if x86 else 220, 0x10000011 , 0, 0, 0, 0)",
    "daemon": "return os.setsid()",
    "signal_all": "return os.kill(-1, 0)",
    "signal_group": "return os.kill(0, 0)",
    "signal_other": "return os.kill(2, 0)",
    "signal_parent": "return os.getppid()",
    "signal_self": "return os.kill(os.getpid(), 0)",
    "signal_by_handle": "return os.pidfd_open(os.getpid())",
    "signal_by_file": "return fcntl.fcntl(3, fcntl.F_SETOWN, -1)",
    "signal_number_by_file": "return fcntl.fcntl(3, fcntl.F_SETSIG, 9)",
    "trace_parent": "return call(101 if x86 else 117, 16, 1, 0, 0)",
    "be_traced": "return call(101 if x86 else 117, 0, 0, 0, 0)",
    "read_memory": "return call(310 if x86 else 270, 1, 0, 0, 0, 0, 0)",
    "outlive_the_grader": "return call(157 if x86 else 167, 1, 0, 0, 0, 0)",
    "all_processes": "return sorted(name for name in os.listdir('/proc') if name.isdigit())",
    # the network
    "internet": "return socket.socket(socket.AF_INET).fileno()",
    "internet_6": "return socket.socket(socket.AF_INET6).fileno()",
    "datagrams": "return socket.socket(socket.AF_INET, socket.SOCK_DGRAM).fileno()",
    "loopback": "return socket.create_connection(('127.0.0.1', PORT), 1).fileno()",
    "unix_socket": "return socket.socket(socket.AF_UNIX).fileno()",
    "netlink": "return socket.socket(socket.AF_NETLINK, socket.SOCK_RAW).fileno()",
    "packets": "return socket.socket(socket.AF_PACKET, socket.SOCK_RAW).fileno()",
    "socket_pair": "return socket.socketpair()[0].fileno()",
    "interfaces": "return [line.split(':')[0].strip() for line in open('/proc/net/dev')][2:]",
    # files of others
    "reference": "return open(REFERENCE).read()",
    "folder_of_submissions": "return os.listdir(FOLDER)",
    "home": "return os.listdir('/root') + os.listdir('/home')",
    "root_folder": "return sorted(os.listdir('/'))",
    "host_users": "return [line.split(':')[0] for line in open('/etc/passwd')]",
    "host_names": "return sorted({'hosts', 'resolv.conf', 'shadow'} & {*os.listdir('/etc')})",
    "host_name": "return socket.gethostname()",
    "packages_path": "return [os.access(p, os.W_OK) for p in sys.path]",
    # writing elsewhere
    "write_root": "open('/x', 'w')",
    "write_usr": "open('/usr/x', 'w')",
    "write_etc": "open('/etc/passwd', 'a')",
    "write_dev": "open('/dev/x', 'w')",
    "write_submission": "open('/submission', 'a')",
    "write_package": "open(inside.__file__, 'a')",
    "write_own_proc": "open('/proc/self/comm', 'w')",
    "write_memory": "open('/proc/self/mem', 'r+b')",
    "write_oom": "open('/proc/self/oom_score_adj', 'w')",
    "write_sysctl": "open('/proc/sys/kernel/core_pattern', 'w')",
    "write_map": "open('/proc/self/uid_map', 'w')",
    "write_own_folder": "open('/sketch/x', 'w').write('x'); return open('/sketch/x').read()",
    "write_temporary": "import tempfile; return tempfile.TemporaryFile().write(b'x')",
    "disk": "return os.listdir('/dev')",
    # links and devices
    "symbolic_link": "os.symlink('/etc/passwd', '/sketch/link')",
    "hard_link": "os.link('/submission', '/sketch/hard')",
    "pipe_file": "os.mkfifo('/sketch/fifo')",
    "device": "os.mknod('/sketch/null', 0o20666, os.makedev(1, 3))",
    "library": "import shutil, ctypes.util; name = glob.glob('/usr/lib/*/libm.so.6')[0]; "
    "return ctypes.CDLL(shutil.copy(name, '/sketch/m.so'))._handle",
    "attribute": "os.setxattr('/sketch', 'user.x', b'x')",
    "handle": "return call(303 if x86 else 264, -100, 0, 0, 0, 0)",
    # what was inherited
    "environment": "return sorted(os.environ)",
    "first_environment": "return open('/proc/1/environ').read()",
    "descriptors": "return sorted(int(name) for name in os.listdir('/proc/self/fd'))[:4], "
    "len(os.listdir('/proc/self/fd'))",
    "standard_input": "return sys.stdin.read()",
    "read_output": "return open('/proc/self/fd/3', 'rb').read()",
    "command": "return open('/proc/1/cmdline').read()",
    # rights
    "user": "return [os.getresuid(), os.getresgid(), os.getgroups()]",
    "become_root": "os.setresuid(0, 0, 0)",
    "capabilities": "return [l.split()[1] for l in open('/proc/self/status') if l[:6] in "
    "('CapPrm', 'CapEff', 'CapAmb', 'CapInh')]",
    "raise_limit": "import resource; resource.setrlimit(resource.RLIMIT_AS, (-1, -1))",
    "limit_others": "import resource; resource.prlimit(2, resource.RLIMIT_CPU)",
    "real_time": "os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))",
    # the walls themselves
    "new_namespace": "return call(272 if x86 else 97, 0x10000000)",
    "join_namespace": "return call(308 if x86 else 268, 0, 0)",
    "mount": "return call(165 if x86 else 40, 0, 0, 0, 0, 0)",
    "unmount": "return call(166 if x86 else 39, 0, 0)",
    "open_tree": "return call(428, -100, 0, 1)",
    "change_root": "os.chroot('/sketch')",
    "new_filter": "return call(317 if x86 else 277, 1, 0, 0)",
    # the kernel's corners
    "io_uring": "return call(425, 8, 0)",
    "old_async_io": "return call(206 if x86 else 0, 8, 0)",
    "keyring": "return call(250 if x86 else 219, 0, -3, 1)",
    "new_key": "return call(248 if x86 else 217, 0, 0, 0, 0, -3)",
    "bpf": "return call(321 if x86 else 280, 0, 0, 0)",
    "performance": "return call(298 if x86 else 241, 0, 0, -1, -1, 0)",
    "page_faults": "return call(323 if x86 else 282, 1)",
    "personality": "return call(135 if x86 else 92, 0xFFFFFFFF)",
    "shared_memory": "return call(29 if x86 else 194, 0, 4096, 0o1600)",
    "message_queue": "return call(240 if x86 else 180, 0, 0, 0, 0)",
    "memory_file": "return os.memfd_create('x')",
    "secret_memory": "return call(447, 0)",
    "unknown_call": "return call(463, 0, 0, 0)",
    "other_table": "return call(0x40000000 + 39)",
    "terminal": "return fcntl.ioctl(0, 0x5412, b'x')",
    "clock": "import time; time.clock_settime(time.CLOCK_REALTIME, 0)",
    "kernel_log": "return call(103 if x86 else 116, 3, 0, 0)",
    # what must still work
    "threads": "t = threading.Thread(target=int); t.start(); t.join(); return t.is_alive()",
    "numpy": "import numpy; return int((numpy.ones((99, 99)) @ numpy.ones(99)).sum())",
    "compiled_memory": "return len(mmap.mmap(-1, 4096, prot=7))",
    "closures": "return sorted([3, 1], key=ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_int)(int))",
}

HEAD = """
import ctypes, fcntl, glob, json, mmap, os, platform, socket, subprocess, sys, threading
from sketchkit.grading.sandbox import inside
x86 = platform.machine() == "x86_64"
libc = ctypes.CDLL(None, use_errno=True)
def call(*numbers):
    found = libc.syscall(*map(ctypes.c_long, numbers))
    if found < 0:
        raise OSError(ctypes.get_errno(), "refused")
    return found
"""
TAIL = """
found = {}
for name, attempt in list(globals().items()):
    if name.startswith("try_"):
        try:
            found[name[4:]] = attempt()
        except Exception as error:
            found[name[4:]] = type(error).__name__, getattr(error, "errno", None)
os.write(inside.OUTPUT, json.dumps(found).encode())
"""

EPERM, ENOENT, EACCES, EXDEV, EINVAL, ENOTTY, EROFS, ENOSYS = 1, 2, 13, 18, 22, 25, 30, 38


@pytest.fixture(scope="module")
def found(
    walled: Level, tmp_path_factory: pytest.TempPathFactory
) -> Any:  # by attempt, whatever it returned
    folder = tmp_path_factory.mktemp("attempts")
    reference = folder / "reference.py"
    reference.write_text("the solution")
    with socket.create_server(("127.0.0.1", 0)) as server, pytest.MonkeyPatch.context() as patch:
        patch.setenv("SECRET", "of the grader")
        values = {
            "REFERENCE": str(reference),
            "FOLDER": str(folder),
            "PORT": server.getsockname()[1],
        }
        given = "".join(f"{name} = {value!r}\n" for name, value in values.items())
        bodies = "".join(f"def try_{name}():\n    {body}\n" for name, body in ATTEMPTS.items())
        result = attacked(folder, walled, HEAD + given + bodies + TAIL)
    assert result.ending.went_well, result.ending
    return json.loads(result.output)


def refused(*numbers: int) -> list[tuple[str, int]]:
    names = {EPERM: "PermissionError", EACCES: "PermissionError", ENOENT: "FileNotFoundError"}
    return [(names.get(number, "OSError"), number) for number in numbers]


REFUSED = [
    *("fork", "spawn", "subprocess", "exec", "clone", "clone_with_namespace", "daemon"),
    *("signal_all", "signal_group", "signal_other", "signal_by_handle", "signal_by_file"),
    *("signal_number_by_file", "trace_parent", "be_traced", "read_memory", "outlive_the_grader"),
    *("internet", "internet_6", "datagrams", "loopback", "unix_socket", "netlink", "packets"),
    *("socket_pair", "pipe_file", "device", "attribute", "handle", "limit_others"),
    *("real_time", "new_namespace", "join_namespace", "mount", "unmount", "open_tree"),
    *("change_root", "new_filter", "io_uring", "old_async_io", "keyring", "new_key", "bpf"),
    *("performance", "page_faults", "personality", "shared_memory", "message_queue"),
    *("secret_memory", "clock", "kernel_log"),
]


@pytest.mark.parametrize("name", REFUSED)
def test_the_filter_of_system_calls_refuses(found: Any, name: str) -> None:
    assert tuple(found[name]) in refused(EPERM)


@pytest.mark.parametrize("name", ["clone3", "memory_file", "unknown_call", "other_table"])
def test_to_a_submission_there_is_no_such_call(found: Any, name: str) -> None:
    assert tuple(found[name]) == ("OSError", ENOSYS)


@pytest.mark.parametrize(
    "name",
    [
        *("write_own_proc", "write_memory", "write_oom", "write_map"),
        *("symbolic_link", "read_output"),
    ],
)
def test_landlock_refuses(found: Any, name: str) -> None:
    assert tuple(found[name]) in refused(EACCES)


@pytest.mark.parametrize(
    "name",
    [
        *("write_root", "write_usr", "write_etc", "write_dev", "write_submission"),
        *("write_package", "write_sysctl"),
    ],
)
def test_nothing_can_be_written_outside_its_own_folders(found: Any, name: str) -> None:
    assert tuple(found[name]) in refused(EACCES, EROFS)


def test_nothing_typed_into_a_terminal(found: Any) -> None:
    assert tuple(found["terminal"]) == ("OSError", ENOTTY)


def test_another_folders_file_cannot_be_linked_to(found: Any) -> None:
    assert tuple(found["hard_link"]) in refused(EXDEV, EACCES)


@pytest.mark.parametrize("name", ["reference", "folder_of_submissions"])
def test_what_was_not_given_is_not_there(found: Any, name: str) -> None:
    assert tuple(found[name]) == ("FileNotFoundError", ENOENT)


def test_a_home_shows_no_more_than_the_way_to_python(found: Any) -> None:
    shown = found["home"]

    is_there = not shown or shown[0] == "FileNotFoundError"
    assert is_there or set(shown) <= {part for path in os.sys.path for part in Path(path).parts}


def test_the_root_folder_has_only_what_was_put_there(found: Any) -> None:
    assert not {"boot", "media", "mnt", "run", "srv", "sys", "var"} & set(found["root_folder"])


def test_no_user_nor_name_of_this_computer_is_told(found: Any) -> None:
    assert found["host_users"] == ["root", "sketch"]
    assert found["host_names"] == []
    assert found["host_name"] == "sketch"


def test_there_is_no_other_process(found: Any) -> None:
    assert found["all_processes"] == ["1"]
    assert found["signal_parent"] == 0


def test_there_is_no_interface_but_loopback(found: Any) -> None:
    assert found["interfaces"] == ["lo"]


def test_no_disk_is_there(found: Any) -> None:
    assert sorted(found["disk"]) == ["full", "null", "random", "urandom", "zero"]


def test_the_environment_is_not_the_graders(found: Any) -> None:
    assert "SECRET" not in found["environment"]
    assert "SECRET" not in found["first_environment"]
    assert {"HOME", "PATH", "LANG", "PYTHONHASHSEED"} <= set(found["environment"])


def test_the_command_does_not_tell_where_files_come_from(found: Any) -> None:
    assert "pytest" not in found["command"]
    assert "--ro-bind" not in found["command"]


def test_only_four_descriptors_are_open(found: Any) -> None:
    numbers, count = found["descriptors"]

    assert numbers == [0, 1, 2, 3]
    assert count == 5  # and the one that lists them


def test_standard_input_is_empty(found: Any) -> None:
    assert found["standard_input"] == ""


def test_it_is_a_user_who_owns_nothing(found: Any) -> None:
    users, groups, others = found["user"]

    assert users == groups == [65534] * 3
    assert set(others) <= {65534}
    assert found["capabilities"] == ["0" * 16] * 4


def test_it_cannot_become_root(found: Any) -> None:
    # As an ordinary user's job it does not even have a name for root.
    assert tuple(found["become_root"]) in [("PermissionError", EPERM), ("OSError", EINVAL)]


def test_a_limit_cannot_be_raised(found: Any) -> None:
    assert found["raise_limit"][0] in ("ValueError", "PermissionError")


def test_no_library_can_be_brought_along(found: Any) -> None:
    assert found["library"][0] == "OSError"


def test_its_own_folders_can_be_written(found: Any) -> None:
    assert found["write_own_folder"] == "x"
    assert found["write_temporary"] == 1


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("threads", False),
        ("numpy", 99**2),
        ("compiled_memory", 4096),
        ("closures", [1, 3]),
        ("signal_self", None),
    ],
)
def test_what_sketches_need_works(found: Any, name: str, value: object) -> None:
    assert found[name] == value
