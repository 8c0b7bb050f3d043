"""A display for the tests that open windows."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.runtime.windows import x_server


@pytest.fixture(scope="session")
def display() -> Iterator[str]:
    with x_server() as name:
        yield name
