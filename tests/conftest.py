"""What all tests share: canvases, one OpenGL context, and the goldens."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings

from sketchkit.api.graphics import PGraphics
from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.draw.backend import Backend
from tests import canvases
from tests.goldens import Failures, Goldens

FAILURES = pytest.StashKey[Failures]()

# The same examples at every run, and no failure because the machine was busy.
settings.register_profile("repeatable", derandomize=True, deadline=None)
settings.load_profile("repeatable")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-golden",
        action="store_true",
        help="write the goldens of the chosen tests anew: pytest --update-golden -k NAME",
    )


def pytest_configure(config: pytest.Config) -> None:
    failures = Failures(config.rootpath / "out" / "golden-failures")
    config.stash[FAILURES] = failures
    if _is_first_process(config):
        failures.clear()


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    if page := config.stash[FAILURES].write_page():
        terminalreporter.write_line(f"pictures that differ: {page}")


def _is_first_process(config: pytest.Config) -> bool:
    """Return whether this is not one of the workers of pytest-xdist."""
    return not hasattr(config, "workerinput")


@pytest.fixture(scope="session")
def goldens(pytestconfig: pytest.Config) -> Goldens:
    return Goldens(
        Path(__file__).parent / "golden",
        pytestconfig.stash[FAILURES],
        is_updating=pytestconfig.getoption("--update-golden"),
    )


@pytest.fixture(scope="session")
def one_gl_backend() -> Iterator[GlBackend]:
    backend = GlBackend.headless()
    yield backend
    backend.close()


@pytest.fixture
def gl_backend(one_gl_backend: GlBackend) -> Iterator[GlBackend]:
    """The OpenGL renderer; its context is current, whichever another test has made."""
    with one_gl_backend.context:
        yield one_gl_backend


@pytest.fixture(params=["gl", "cpu"])
def backend(request: pytest.FixtureRequest) -> Backend:
    """Each renderer in turn."""
    if request.param == "gl":
        shared: GlBackend = request.getfixturevalue("gl_backend")
        return shared
    return CpuBackend()


@pytest.fixture
def flat() -> PGraphics:
    """A P2D canvas of 100 x 100 that draws nothing, for its draw list."""
    return canvases.flat_canvas()


@pytest.fixture
def deep() -> PGraphics:
    """A P3D canvas of 100 x 100 that draws nothing, for its draw list."""
    return canvases.deep_canvas()
