"""SVG drawings to plain data."""
