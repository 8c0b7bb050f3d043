"""sketchkit: Processing for Python, without Java."""

__version__ = "0.1.0"
