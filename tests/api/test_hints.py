"""What hints switch, and which are refused."""

from __future__ import annotations

import pytest

from sketchkit.core.constants import (
    DISABLE_DEPTH_MASK,
    DISABLE_DEPTH_TEST,
    DISABLE_TEXTURE_MIPMAPS,
    ENABLE_DEPTH_MASK,
    ENABLE_DEPTH_TEST,
)
from sketchkit.core.errors import SketchError
from tests.canvases import pipeline_of


def test_depth_test_is_switched_off_and_on(deep):
    tests = []
    for hint in (DISABLE_DEPTH_TEST, ENABLE_DEPTH_TEST):
        deep.hint(hint)
        tests.append(pipeline_of(deep).depth_test)

    assert tests == [False, True]


def test_depth_mask_is_switched_off_and_on(deep):
    masks = []
    for hint in (DISABLE_DEPTH_MASK, ENABLE_DEPTH_MASK):
        deep.hint(hint)
        masks.append(pipeline_of(deep).depth_write)

    assert masks == [False, True]


def test_hint_stays_from_frame_to_frame(deep):
    deep.hint(DISABLE_DEPTH_TEST)
    deep.end_frame()
    deep.begin_frame()

    assert not pipeline_of(deep).depth_test


@pytest.mark.parametrize("unknown", ["x", 99, 0, None, [2]])
def test_unknown_hint_is_refused(deep, unknown):
    with pytest.raises(SketchError, match=r"hint\(\) takes DISABLE_DEPTH_TEST, "):
        deep.hint(unknown)


def test_hint_for_java_alone_changes_nothing(deep):
    before = pipeline_of(deep)
    deep.hint(DISABLE_TEXTURE_MIPMAPS)

    assert pipeline_of(deep) == before
