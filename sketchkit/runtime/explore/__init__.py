"""Exploring a sketch from outside: from a pixel to the line that drew it, and why nothing shows."""
