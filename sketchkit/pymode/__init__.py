"""Python Mode: what Processing's own Python was, a Python 2, told in Python 3."""
