"""Values that Processing itself calculates, compared with ours: see `calls.py`."""
