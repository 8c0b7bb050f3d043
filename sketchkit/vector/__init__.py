"""Vector output: what a canvas records, as the shapes of an SVG or PDF file."""
