"""The error that an assignment can cause: told to the instructor, with the line to look at."""

from __future__ import annotations


class AssignmentError(Exception):
    """A mistake in an assignment.

    Parameters
    ----------
    problem : str
        What is wrong: a whole sentence.
    file : str, optional
        The file that it is in, relative to the assignment.
    line : int, optional
        Where in the file.
    hint : str, optional
        What to write instead: a whole sentence.
    """

    def __init__(
        self,
        problem: str,
        *,
        file: str = "assignment.toml",
        line: int | None = None,
        hint: str | None = None,
    ) -> None:
        super().__init__(problem)
        self.problem = problem
        self.file = file
        self.line = line
        self.hint = hint

    def __str__(self) -> str:
        place = f"{self.file}, line {self.line}" if self.line else self.file
        rest = f"\n    {self.hint}" if self.hint else ""
        return f"{place}: {self.problem}{rest}"
