"""Make tests/values/processing_values.json anew: what Processing itself calculates.

    python -m tests.values.make_processing_values write FOLDER
    python -m tests.values.make_processing_values take FOLDER

`write` puts the calls of `calls.py` into FOLDER as a sketch, `processing_values.py`. Let any
program that runs such a file on Processing's core run its first frame: the sketch leaves the
results beside itself, in `values.json`. `take` copies them over the record.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from tests.values.calls import every_call

RECORD = Path(__file__).with_name("processing_values.json")

# Names that Python has too: here they shall be Processing's own, which the sketch itself has.
AS_IN_JAVA = (
    *("abs", "binary", "hex", "map", "max", "min", "pow", "random", "round", "unbinary", "unhex"),
    *("parseBoolean", "parseByte", "parseChar", "parseFloat", "parseInt", "split", "join"),
)

SKETCH = """\
import builtins
import json
import math

GROUPS = {groups}
AS_IN_JAVA = {as_in_java}


def setup():
    size(100, 100, P2D)
    results = {{}}
    for group, calls in GROUPS:
        scope = {{name: getattr(this, name) for name in AS_IN_JAVA}}
        scope["__builtins__"] = __builtins__
        results[group] = [[line, value_of(line, scope)] for line in calls]
    with open({target!r}, "w") as file:
        json.dump(results, file)


def value_of(line, scope):
    *statements, last = line.split("; ")
    try:
        for statement in statements:
            builtins.exec(statement, scope)
        return plain(eval(last, scope))
    except Exception as error:
        return {{"error": type(error).__name__ + ": " + str(error)}}


def plain(value):
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, float):
        return value if math.isfinite(value) else str(float(value))
    if isinstance(value, int):
        return int(value)
    if isinstance(value, str):
        return str(value)
    if isinstance(value, PVector):
        return {{"PVector": [plain(value.x), plain(value.y), plain(value.z)]}}
    return [plain(item) for item in value]


def draw():
    pass
"""


def write(folder: Path) -> None:
    """Write the sketch."""
    folder.mkdir(parents=True, exist_ok=True)
    text = SKETCH.format(
        groups=list(every_call()),
        as_in_java=AS_IN_JAVA,
        target=str(folder.absolute() / "values.json"),
    )
    (folder / "processing_values.py").write_text(text, encoding="utf-8")


def take(folder: Path) -> None:
    """Copy the results, one call a line."""
    results = json.loads((folder / "values.json").read_text(encoding="utf-8"))
    groups = [
        f" {json.dumps(group)}: [\n"
        + ",\n".join(f"  {json.dumps(pair)}" for pair in calls)
        + "\n ]"
        for group, calls in results.items()
    ]
    RECORD.write_text("{\n" + ",\n".join(groups) + "\n}\n", encoding="utf-8")


def main() -> None:
    """Do what the command line says."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("action", choices=["write", "take"])
    parser.add_argument("folder", type=Path)
    options = parser.parse_args()
    {"write": write, "take": take}[options.action](options.folder)


if __name__ == "__main__":
    main()
