"""Models of any format to plain data."""
