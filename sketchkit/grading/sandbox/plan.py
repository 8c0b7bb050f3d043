"""What the grader tells the process inside: it goes through an environment variable, as JSON."""

from __future__ import annotations

import dataclasses
import json
from dataclasses import dataclass, field

from sketchkit.grading.sandbox.job import Limits

VARIABLE = "SKETCHKIT_SANDBOX"
OUTPUT = 3  # the file descriptor that the job writes its output to
NOBODY = 65534  # the user, and the group, that a job runs as


@dataclass(frozen=True)
class Plan:
    """How the process inside prepares itself.

    Attributes
    ----------
    paths : dict of str to str
        Names as the job knows them ("/submission", "/sketch"), and where they are.
    readable : tuple of str
        Files and folders that may be read.
    own : tuple of str
        Folders that may be written.
    limits : Limits
    is_walled : bool
        Whether bubblewrap is around it.
    has_seccomp, has_landlock : bool
        The walls to put up.
    is_trial : bool
        Whether a wall that cannot be put up is only remarked on.
    output : str or None
        Where the output goes: the number of a file descriptor; on Windows, a file.
    ready : int
        A file descriptor, to say that all walls are up. Windows has no walls, and does not.
    """

    paths: dict[str, str]
    readable: tuple[str, ...]
    own: tuple[str, ...]
    limits: Limits = field(default_factory=Limits)
    is_walled: bool = False
    has_seccomp: bool = False
    has_landlock: bool = False
    is_trial: bool = False
    output: str | None = None
    ready: int = -1

    def to_json(self) -> str:
        """Return it as one line."""
        return json.dumps(dataclasses.asdict(self))

    @classmethod
    def from_json(cls, text: str) -> Plan:
        """Read what `to_json` wrote."""
        found = json.loads(text)
        found["limits"] = Limits(**found["limits"])
        found["readable"] = tuple(found["readable"])
        found["own"] = tuple(found["own"])
        return cls(**found)
