"""Which kinds of checks there are. A new one is a module and a line here."""

from __future__ import annotations

from typing import Any

from sketchkit.grading.checks import (
    image,
    interaction,
    motion,
    performance,
    sequence,
    source,
    trace,
)
from sketchkit.grading.checks.case import Kind

KINDS: dict[str, Kind[Any]] = {  # each kind has options of its own class
    "image": image.KIND,
    "sequence": sequence.KIND,
    "interaction": interaction.KIND,
    "trace": trace.KIND,
    "source": source.KIND,
    "performance": performance.KIND,
    "motion": motion.KIND,
}
