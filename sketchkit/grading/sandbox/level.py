"""Which walls this computer has: found out by trying them, not by looking for files."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

from sketchkit.grading.sandbox.job import SandboxError


class Strength(IntEnum):
    """How much stands between a submission and the grader's computer."""

    NONE = 0
    LIMITS_ONLY = 1
    PARTIAL = 2
    FULL = 3

    @property
    def in_words(self) -> str:
        """As it is written on the command line and in reports."""
        return self.name.lower().replace("_", " ")


@dataclass(frozen=True)
class Level:
    """The walls of this computer.

    Attributes
    ----------
    bubblewrap, seccomp, landlock, limits : bool
        The walls: namespaces; the filter of system calls; the list of files; rlimits.
    refusal : str
        Why no submission can be run here at all, in a sentence; "" if they can.
    missing : tuple of str
        What was found wanting, as the system said it.
    is_trial : bool
        Whether it is only being found out what holds.
    """

    bubblewrap: bool = False
    seccomp: bool = False
    landlock: bool = False
    limits: bool = False
    refusal: str = ""
    missing: tuple[str, ...] = ()
    is_trial: bool = False

    @property
    def strength(self) -> Strength:
        """How strong they are together."""
        if self.bubblewrap and self.seccomp and self.landlock and self.limits:
            return Strength.FULL
        if self.bubblewrap or self.seccomp or self.landlock:
            return Strength.PARTIAL
        return Strength.LIMITS_ONLY if self.limits else Strength.NONE

    @property
    def name(self) -> str:
        """Its strength: "full", "partial", "limits only" or "none"."""
        return self.strength.in_words

    @property
    def in_words(self) -> str:
        """Its strength, and the walls that there are."""
        there = [wall for wall, is_up in self._walls() if is_up]
        lacking = [wall for wall, is_up in self._walls() if not is_up]
        if not there:
            return f"{self.name}: a submission can do what you can"
        without = f"; without {_listed(lacking)}" if lacking else ""
        return f"{self.name}: {_listed(there)}{without}"

    @property
    def remedy(self) -> str:
        """What to do for a stronger one; "" if it is full."""
        if self.refusal:
            return self.refusal
        if not self.bubblewrap:
            return (
                "On Linux, install bubblewrap (apt install bubblewrap) and allow user namespaces: "
                "sysctl kernel.apparmor_restrict_unprivileged_userns=0 on Ubuntu, and "
                "--security-opt seccomp=unconfined --security-opt systempaths=unconfined for "
                "docker run. Elsewhere, grade in a virtual machine with Linux."
            )
        if self.strength < Strength.FULL:
            return "A newer Linux kernel: seccomp, and Landlock (5.13 and newer), switched on."
        return ""

    def _walls(self) -> tuple[tuple[str, bool], ...]:
        return (
            ("bubblewrap", self.bubblewrap),
            ("seccomp", self.seccomp),
            ("Landlock", self.landlock),
            ("rlimits", self.limits),
        )


def require(level: Level, wanted: Strength) -> None:
    """Make sure that a level is at least as strong as is wanted.

    Raises
    ------
    SandboxError
        If it is not.
    """
    if level.refusal:
        raise SandboxError(level.refusal)
    if level.strength < wanted:
        raise SandboxError(
            f"The sandbox is asked to be {wanted.in_words!r}, but here it is {level.in_words}. "
            f"{level.remedy}"
        )


def _listed(names: list[str]) -> str:
    return " and ".join(part for part in (", ".join(names[:-1]), names[-1]) if part)
