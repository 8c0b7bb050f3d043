"""What is wrong with a text that does not follow the rules of its format, and where."""

from __future__ import annotations


class MalformedError(ValueError):
    """A text cannot be read.

    Attributes
    ----------
    problem : str
        What is wrong: a whole sentence without its full stop.
    line, column : int
        Where, both counted from 1.
    """

    def __init__(self, problem: str, line: int, column: int) -> None:
        super().__init__(f"line {line}, column {column}: {problem}")
        self.problem = problem
        self.line = line
        self.column = column


def malformed_at(text: str, place: int, problem: str) -> MalformedError:
    r"""Return the error for a place in a text, counted in characters from 0.

    Examples
    --------
    >>> str(malformed_at("ab\ncd", 4, "Here"))
    'line 2, column 2: Here'
    """
    before = text[:place]
    return MalformedError(problem, before.count("\n") + 1, place - before.rfind("\n"))
