"""The filter of system calls: what a sketch has no business asking of the kernel is refused.

It is a list of refusals, not of permissions. NumPy, Mesa and its compiler of shaders ask for other
calls on other machines, and a list of permissions that forgets one breaks a class's grading; what
a sketch must not do is a shorter list, and it is the second wall: the namespaces are the first.
Three things keep such a list from being slipped past. Calls newer than the list do not exist, as
on an older kernel; the processor's other call tables (i386, x32) are closed; and nothing can be
executed, so that no other program's habits need to be thought of.

The program is written here, in some 60 instructions' worth of Python, and not by libseccomp: that
would have to be installed on each machine, and this wall should need nothing.
"""

from __future__ import annotations

import ctypes
import errno
import os
import platform
import struct
from collections.abc import Iterable, Iterator

from sketchkit.grading.sandbox import kernel

# A process's own affair is to draw. These are refused with "Operation not permitted":
REFUSED = (
    # other processes: none is started, watched, or written to
    *("fork", "vfork", "execve", "execveat", "setsid", "setpgid", "tkill"),
    *("ptrace", "process_vm_readv", "process_vm_writev", "process_madvise", "process_mrelease"),
    *("kcmp", "pidfd_open", "pidfd_getfd", "pidfd_send_signal", "migrate_pages", "move_pages"),
    # namespaces and mounts: the walls themselves
    *("unshare", "setns", "mount", "umount2", "pivot_root", "chroot", "mount_setattr"),
    *("open_tree", "move_mount", "fsopen", "fsconfig", "fsmount", "fspick", "statmount"),
    "listmount",
    # the network, and every other kind of socket
    *("socket", "socketpair"),
    # memory that outlives its mapping is counted by no limit
    *("shmget", "shmat", "shmctl", "semget", "semop", "semctl", "semtimedop"),
    *("msgget", "msgsnd", "msgrcv", "msgctl", "mq_open", "mq_unlink", "mq_timedsend"),
    *("mq_timedreceive", "mq_notify", "mq_getsetattr", "memfd_secret"),
    # ways to have the kernel work behind the filter's back, and what attacks on kernels start from
    *("io_uring_setup", "io_uring_enter", "io_uring_register", "io_setup", "io_submit"),
    *("userfaultfd", "bpf", "perf_event_open", "seccomp", "personality", "modify_ldt"),
    *("add_key", "request_key", "keyctl", "remap_file_pages", "mbind", "set_mempolicy"),
    *("set_mempolicy_home_node", "lsm_get_self_attr", "lsm_set_self_attr", "lsm_list_modules"),
    # files that are not files; attributes, which a folder's size does not count
    *("mknod", "mknodat", "name_to_handle_at", "open_by_handle_at", "uselib", "lookup_dcookie"),
    *("setxattr", "lsetxattr", "fsetxattr", "fanotify_init", "fanotify_mark"),
    # the machine
    *("quotactl", "quotactl_fd", "swapon", "swapoff", "acct", "init_module", "finit_module"),
    *("delete_module", "kexec_load", "kexec_file_load", "reboot", "sethostname", "setdomainname"),
    *("iopl", "ioperm", "syslog", "settimeofday", "clock_settime", "clock_adjtime", "adjtimex"),
    *("vhangup", "nfsservctl", "sched_setscheduler", "sched_setparam", "sched_setattr"),
    "ioprio_set",
)
# These are said not to exist, so that the C library and Mesa take the way they have without them.
# clone3 keeps its flags where a filter cannot look; memfds are memory that no limit counts.
ABSENT = ("clone3", "memfd_create")

CLONE_THREAD = 0x10000
FILE_CONTROLS = (8, 10, 15, 1024, 1026)  # F_SETOWN, F_SETSIG, F_SETOWN_EX, F_SETLEASE, F_NOTIFY
# Not to end with the grader; to let others look into it.
PROCESS_CONTROLS = (kernel.PR_SET_PDEATHSIG, 0x59616D61)
# What Python asks of a file or a terminal: TCGETS, TIOCGWINSZ, FIONREAD, FIONBIO, FIO(N)CLEX.
# Nothing that types into a terminal (TIOCSTI), or that a driver might misunderstand.
DEVICE_CONTROLS = (0x5401, 0x5413, 0x541B, 0x5421, 0x5450, 0x5451)

LOAD, JUMP_IF_EQUAL, JUMP_IF_ABOVE, JUMP_IF_ANY_BIT, RETURN = 0x20, 0x15, 0x25, 0x45, 0x06
ALLOW, KILL, REFUSE = 0x7FFF0000, 0x80000000, 0x00050000  # REFUSE + errno
CALL_NUMBER, ARCHITECTURE, ARGUMENTS = 0, 4, 16  # byte offsets in what a filter sees

Instruction = tuple[int, int, int, int]  # operation, steps if true, steps if false, number


def install() -> None:
    """Put the filter on all threads of this process, for good.

    Raises
    ------
    OSError
        If the kernel has no such filters, or does not allow one.
    """
    if not kernel.is_known():
        raise OSError("no table of system calls for this system")
    instructions = program(os.getpid())
    code = ctypes.create_string_buffer(b"".join(struct.pack("=HBBI", *one) for one in instructions))
    header = _Program(len(instructions), ctypes.addressof(code))
    set_filter, all_threads = 1, 1
    kernel.prctl(kernel.PR_SET_NO_NEW_PRIVS, 1)
    if kernel.call("seccomp", set_filter, all_threads, header) != 0:
        raise OSError("a thread could not be brought under the filter")


class _Program(ctypes.Structure):
    _fields_ = (("length", ctypes.c_ushort), ("code", ctypes.c_void_p))


def program(own_pid: int) -> list[Instruction]:
    """Return the filter for a process, as the kernel's classic BPF."""
    return [
        (LOAD, 0, 0, ARCHITECTURE),
        (JUMP_IF_EQUAL, 1, 0, kernel.ARCHITECTURES[platform.machine()]),
        _answer(KILL),
        (LOAD, 0, 0, CALL_NUMBER),
        (JUMP_IF_ABOVE, 0, 1, kernel.NEWEST),  # x32's numbers are above it too
        _answer(REFUSE + errno.ENOSYS),
        *_refusals(REFUSED, errno.EPERM),
        *_refusals(ABSENT, errno.ENOSYS),
        *_if_called("clone", _allowing_bits(0, CLONE_THREAD)),
        *_to_itself_alone(own_pid),
        *_if_called("ioctl", _allowing(1, DEVICE_CONTROLS, errno.ENOTTY)),
        *_if_called("fcntl", _refusing(1, FILE_CONTROLS)),
        *_if_called("prctl", _refusing(0, PROCESS_CONTROLS)),
        _answer(ALLOW),
    ]


def _to_itself_alone(own_pid: int) -> Iterator[Instruction]:
    """Allow signals to itself, which abort() needs, and limits of its own."""
    for name in ("kill", "tgkill", "rt_sigqueueinfo", "rt_tgsigqueueinfo"):
        yield from _if_called(name, _allowing(0, (own_pid,), errno.EPERM))
    yield from _if_called("prlimit64", _allowing(0, (0, own_pid), errno.EPERM))


def _refusals(names: Iterable[str], error: int) -> Iterator[Instruction]:
    for name in names:
        yield from _if_called(name, [_answer(REFUSE + error)])


def _if_called(name: str, then: list[Instruction]) -> Iterator[Instruction]:
    """Do something if it is this call; `then` must come to an answer."""
    wanted = kernel.number(name)
    if wanted is not None:
        yield (JUMP_IF_EQUAL, 0, len(then), wanted)
        yield from then


def _allowing_bits(argument: int, bits: int) -> list[Instruction]:
    return [
        _load(argument),
        (JUMP_IF_ANY_BIT, 0, 1, bits),
        _answer(ALLOW),
        _answer(REFUSE + errno.EPERM),
    ]


def _allowing(argument: int, values: tuple[int, ...], error: int) -> list[Instruction]:
    checks = (((JUMP_IF_EQUAL, 0, 1, value), _answer(ALLOW)) for value in values)
    return [_load(argument), *(one for pair in checks for one in pair), _answer(REFUSE + error)]


def _refusing(argument: int, values: tuple[int, ...]) -> list[Instruction]:
    refusal = _answer(REFUSE + errno.EPERM)
    checks = (((JUMP_IF_EQUAL, 0, 1, value), refusal) for value in values)
    return [_load(argument), *(one for pair in checks for one in pair), _answer(ALLOW)]


def _load(argument: int) -> Instruction:
    """Load the low half of an argument: all that the kernel looks at in those compared here."""
    return (LOAD, 0, 0, ARGUMENTS + 8 * argument)  # little-endian, as both processors are


def _answer(action: int) -> Instruction:
    return (RETURN, 0, 0, action)
