"""The page of `sketchkit diff`: two pictures and what the grader says of them."""

from __future__ import annotations

from sketchkit.assets.output import U8
from sketchkit.grading.images.verdict import Tolerance, Verdict
from sketchkit.grading.pages.writing import data_uri, page


def diff_page(name: str, expected_name: str, submitted: U8, expected: U8, verdict: Verdict) -> str:
    """Return a page, all in one file, about two pictures, (h, w, 3), and their verdict."""
    tolerance = Tolerance()
    return page(
        "diff.html.j2",
        title=f"{name} and {expected_name}",
        is_alike=verdict.is_alike,
        verdict="They are alike." if verdict.is_alike else "They are not alike.",
        figures=[
            ("FLIP, mean", f"{verdict.flip_mean:.4f}", f"at most {tolerance.mean}"),
            ("FLIP, 99th percentile", f"{verdict.flip_high:.3f}", f"at most {tolerance.high}"),
            ("largest region", f"{verdict.region} px", f"at most {tolerance.region} px"),
        ],
        label=f"{name} (drawn) and {expected_name} (expected)",
        submitted_uri=data_uri(submitted),
        expected_uri=data_uri(expected),
        heat_uri=data_uri(verdict.heat),
        caption=verdict.reason,
    )
