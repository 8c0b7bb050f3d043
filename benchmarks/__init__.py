"""How fast sketchkit is, beside Processing and py5: `python -m benchmarks`."""
