"""Make sketchkit/reference/processing_names.csv anew.

    python -m tests.reference.make_processing_names TABLE

TABLE is a CSV file of all of Processing's public names, as its reference and its source have them,
with the columns owner (the class; empty for what a sketch sees by itself), name, kind, tier and
category. Tier 1 is what Processing's reference shows or coursework uses, 2 what other sketches use,
3 all else. Other columns are dropped, and so are operators, which are no names.
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

from sketchkit.reference.names import COLUMNS, TABLE


def main(source: Path) -> None:
    """Write the table from a larger one."""
    with source.open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["name"].isidentifier()]
    rows.sort(key=lambda row: (row["owner"], row["name"], row["kind"]))
    with TABLE.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
