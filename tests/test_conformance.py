"""Each backend is exactly what the protocol says; no OpenGL context is needed to see it."""

from __future__ import annotations

import inspect
from collections.abc import Callable

import pytest

from sketchkit.backends.cpu.executor import CpuBackend
from sketchkit.backends.gl.executor import GlBackend
from sketchkit.backends.listing import ListingBackend
from sketchkit.draw.backend import Backend

BACKENDS = (CpuBackend, GlBackend, ListingBackend)
BESIDES = {GlBackend: {"present"}}  # what a window asks of the one backend that has one

every_backend = pytest.mark.parametrize("backend", BACKENDS)


def methods_of(kind: type) -> dict[str, Callable[..., object]]:
    """Return the public methods of a class; ways to make an object are none of them."""
    return {
        name: value
        for name, value in vars(kind).items()
        if inspect.isfunction(value) and not name.startswith("_")
    }


@every_backend
def test_backend_has_the_methods_of_the_protocol_and_no_others(backend: type) -> None:
    expected = methods_of(Backend).keys() | BESIDES.get(backend, set())

    assert methods_of(backend).keys() == expected


@every_backend
@pytest.mark.parametrize("method", methods_of(Backend))
def test_method_has_the_signature_of_the_protocol(backend: type, method: str) -> None:
    expected = inspect.signature(getattr(Backend, method), eval_str=True)

    assert inspect.signature(getattr(backend, method), eval_str=True) == expected


@every_backend
def test_backend_has_a_name_of_its_own(backend: type[Backend]) -> None:
    others = [other.name for other in BACKENDS if other is not backend]

    assert backend.name
    assert backend.name not in others
