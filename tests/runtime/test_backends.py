import pytest

from sketchkit.runtime import backends
from sketchkit.runtime.backends import MAKERS, RendererError, open_backend


def test_cpu_is_made_by_name() -> None:
    choice = open_backend("cpu")

    assert choice.backend.name == "cpu"
    assert choice.remark is None


def test_cpu_stands_in_where_there_is_no_opengl(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(MAKERS, "gl", ("no_such_module", "GlBackend"))

    choice = open_backend()

    assert choice.backend.name == "cpu"
    assert "no_such_module" in str(choice.remark)


def test_renderer_that_was_asked_for_is_not_replaced(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(backends.MAKERS, "gl", ("no_such_module", "GlBackend"))

    with pytest.raises(RendererError, match="no_such_module"):
        open_backend("gl")
