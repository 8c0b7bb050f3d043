"""The same drawing, drawn otherwise: so that a report can say what a sketch has left out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from sketchkit.draw.recorder import Recorder
from sketchkit.draw.stage import Stage


def _without_depth(stage: Stage) -> Stage:
    return replace(stage, depth_test=False)


def _without_lights(stage: Stage) -> Stage:
    return replace(stage, lights=None)


VARIANTS: dict[str, Callable[[Stage], Stage]] = {
    "depth test off": _without_depth,
    "lights off": _without_lights,
}


def changing(variant: str) -> Callable[[Recorder], None]:
    """Return what alters a recorder to a variant; stages that were one stay one."""
    alter = VARIANTS[variant]

    def change(recorder: Recorder) -> None:
        altered = {id(stage): alter(stage) for stage in recorder.stages}
        recorder.stages = [altered[id(stage)] for stage in recorder.stages]

    return change
