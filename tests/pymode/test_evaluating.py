from pathlib import Path

import pytest

from tests.pymode.running import run, value


@pytest.mark.parametrize(
    ("expression", "expected"),
    [("eval('9/2')", 4), ("eval(' 1 <> 2')", True), ("eval('0777')", 511)],
)
def test_texts_are_evaluated_as_python_2(expression: str, expected: object) -> None:
    assert value(expression) == expected


def test_text_that_is_run_is_python_2(capsys: pytest.CaptureFixture[str]) -> None:
    found = run("exec 'x = 7 / 2; print x'")

    assert found["x"] == 3
    assert capsys.readouterr().out == "3\n"


def test_a_function_finds_what_a_text_in_it_has_bound() -> None:
    found = run(
        """
        def f(a):
            exec 'z = a / 2'
            return z
        result = f(5)
        """
    )

    assert found["result"] == 2


def test_text_can_have_names_of_its_own() -> None:
    found = run("names = {'a': 5}\nexec 'b = a / 2' in names\nc = eval('b / 2', names)")

    assert found["names"]["b"] == 2
    assert found["c"] == 1


def test_file_that_is_run_is_python_2(tmp_path: Path) -> None:
    file = tmp_path / "more.py"
    file.write_bytes(b"x = 7 / 2\r\nif x <> 2:\r\n\ty = `x`\r\n")

    found = run(f"execfile({str(file)!r})")

    assert (found["x"], found["y"]) == (3, "3")
