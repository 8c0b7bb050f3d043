"""Grading: a class's sketches, judged fairly and safely."""
