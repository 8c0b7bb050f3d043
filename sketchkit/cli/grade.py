"""`sketchkit grade`: a class's sketches judged against an assignment."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import click
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

from sketchkit.cli import grade_init, say
from sketchkit.core.errors import SketchError
from sketchkit.grading.assignment.assignment import Assignment
from sketchkit.grading.assignment.errors import AssignmentError
from sketchkit.grading.assignment.load import load
from sketchkit.grading.batch.check import check
from sketchkit.grading.batch.executors import Executor, open_executor
from sketchkit.grading.batch.grade import Batch, grade, prepare, setting_for
from sketchkit.grading.batch.renders import Setting
from sketchkit.grading.intake.collect import IntakeError, collect
from sketchkit.grading.results import ClassResult, Status, StudentResult
from sketchkit.grading.sandbox.job import SandboxError
from sketchkit.grading.sandbox.level import Level, Strength, require
from sketchkit.grading.sandbox.probe import probe
from sketchkit.grading.texts import visible_line

WRONG_CALL = 2  # exit status
STRENGTHS = {strength.in_words: strength for strength in Strength}
CLASS = "class"  # the command that is meant when none is named
Folder = click.Path(exists=True, file_okay=False, path_type=Path)


class GradeGroup(click.Group):
    """`grade ASSIGNMENT SUBMISSIONS`, beside `grade init` and `grade check`."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Let what names no command be the assignment."""
        is_help = not args or args[0] in ("-h", "--help")
        if not is_help and args[0] not in self.commands:
            args.insert(0, CLASS)
        return super().parse_args(ctx, args)

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the commands that are named."""
        return [name for name in self.commands if name != CLASS]


# The first line of what click is not to wrap is this character alone.
EXAMPLES = """\b
sketchkit grade init boxes               makes an assignment to begin with
sketchkit grade check boxes              tries it on its own reference
sketchkit grade boxes handed-in          judges a class
sketchkit grade boxes handed-in --help   lists the options"""


@click.group(
    cls=GradeGroup,
    name="grade",
    subcommand_metavar="ASSIGNMENT SUBMISSIONS [OPTIONS]",
    epilog=EXAMPLES,
)
def command() -> None:
    """Judge a class's sketches, each behind a wall of its own.

    ASSIGNMENT is a folder with assignment.toml; SUBMISSIONS a folder of folders, of zip files, or
    of single sketches. Pages and tables of marks go to the folder results.
    """


walls = click.option(
    "--require",
    "wanted",
    type=click.Choice(list(STRENGTHS)),
    default=Strength.PARTIAL.in_words,
    show_default=True,
    help="Refuse to run anything behind less than this; sketchkit doctor says what there is.",
)


@command.command(CLASS)
@click.argument("assignment", type=Folder)
@click.argument("submissions", type=click.Path(exists=True, path_type=Path))
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path("results"),
    show_default=True,
    help="The folder of results.",
)
@click.option(
    "--workers",
    type=click.IntRange(1),
    default=os.cpu_count() or 1,
    show_default="one for each processor",
    help="How many submissions are judged at once.",
)
@click.option("--resume", is_flag=True, help="Go on where a batch was interrupted.")
@click.option("--fresh", is_flag=True, help="Render everything anew, whatever was kept.")
@click.option(
    "--executor",
    metavar="WHERE",
    help="dask://host:port: let the workers of a Dask cluster judge.",
)
@walls
def grade_class(  # noqa: PLR0913 # click hands over each option
    assignment: Path,
    submissions: Path,
    out: Path,
    workers: int,
    resume: bool,
    fresh: bool,
    executor: str | None,
    wanted: str,
) -> None:
    """Judge SUBMISSIONS by ASSIGNMENT, and write pages and tables of marks."""
    task, level = _loaded(assignment), _level(wanted)
    say.note(f"Sandbox: {level.in_words}.")
    try:
        chosen = open_executor(executor, workers)
        setting = setting_for(task, out, level, is_fresh=fresh)
        result = _graded(setting, submissions, chosen, is_resumed=resume)
    except (IntakeError, SandboxError, SketchError) as problem:
        say.note(str(problem))
        sys.exit(WRONG_CALL)
    except KeyboardInterrupt:
        say.note("Stopped. What was judged is kept: the same command with --resume goes on.")
        sys.exit(130)
    _sum_up(result, setting.workplace.folder)
    failed = any(student.status is Status.FAILED for student in result.students)
    sys.exit(1 if failed else 0)


def _graded(
    setting: Setting, submissions: Path, executor: Executor, *, is_resumed: bool
) -> ClassResult:
    """Grade a class, with a bar that shows how far it is."""
    taken = collect(submissions, setting.workplace.staging / "submissions")
    with _bar() as bar:
        working = bar.add_task("References", total=None)
        references = prepare(setting)
        bar.update(working, description="Submissions", total=len(taken), completed=0)

        def judged(student: StudentResult) -> None:
            bar.update(working, advance=1, description=visible_line(student.name)[:30])

        return grade(Batch(setting, taken, executor, is_resumed), references, judged)


def _bar() -> Progress:
    return Progress(
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        TextColumn("left:"),
        TimeRemainingColumn(),
        console=Console(stderr=True),
    )


def _sum_up(result: ClassResult, folder: Path) -> None:
    """Print what came of it."""
    marks = sorted(student.points for student in result.students)
    out_of = result.students[0].out_of
    middle = marks[len(marks) // 2]
    click.echo(f"{len(marks)} submissions; half of them have {middle:g} of {out_of:g} or more.")
    for status in Status:
        names = [visible_line(one.name) for one in result.students if one.status is status]
        if names and status is not Status.GRADED:
            shown = ", ".join(names[:5]) + (" …" if len(names) > 5 else "")
            click.echo(f"  {status.value}: {len(names)} ({shown})")
    click.echo(f"{folder / 'index.html'}")


command.add_command(grade_init.command, "init")


@command.command("check")
@click.argument("assignment", type=Folder)
@walls
def grade_check(assignment: Path, wanted: str) -> None:
    """Try ASSIGNMENT: its reference must get all marks, twice alike, an empty sketch none."""
    task, level = _loaded(assignment), _level(wanted)
    try:
        found = check(task, level)
    except SandboxError as reason:
        say.note(str(reason))
        sys.exit(WRONG_CALL)
    for sentence in (*found.problems, *found.notes):
        say.note(sentence)
    if found.problems:
        sys.exit(1)
    click.echo(
        f"{task.title}: the reference has all {task.points:g} marks, twice with the same pictures, "
        "and an empty sketch has none."
    )


def _loaded(folder: Path) -> Assignment:
    try:
        return load(folder)
    except AssignmentError as problem:
        say.note(str(problem))
        sys.exit(WRONG_CALL)


def _level(wanted: str) -> Level:
    level = probe()
    try:
        require(level, STRENGTHS[wanted])
    except SandboxError as problem:
        say.note(str(problem))
        sys.exit(WRONG_CALL)
    return level
