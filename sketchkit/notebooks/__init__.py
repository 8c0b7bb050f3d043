"""Sketches in notebooks and other programs: pictures instead of a window."""
