"""Names of files in `assignment.toml`: they lie in the assignment's folder."""

from __future__ import annotations

from pathlib import Path, PurePosixPath

from sketchkit.core.errors import nearest
from sketchkit.grading.assignment.table import Table


def path_within(table: Table, key: str, name: str) -> Path:
    """Return the path of a name in the assignment's folder, and refuse one that leads out of it."""
    parts = PurePosixPath(name).parts
    if not name.strip() or name.startswith(("/", "\\")) or ".." in parts or ":" in name:
        raise table.error(f"{key} is a name within the assignment's folder, not {name!r}.", key)
    return table.document.folder / name


def similar(path: Path) -> str | None:
    """Return the hint that names what is there."""
    try:
        names = sorted(other.name for other in path.parent.iterdir())
    except OSError:
        return None
    known = nearest(path.name, names)
    return f"Do you mean {known}?" if known else None
