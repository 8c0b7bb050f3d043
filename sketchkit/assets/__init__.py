"""Files to plain data."""
