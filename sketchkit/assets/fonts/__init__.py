"""Fonts: faces, their letters, and what these look like."""
