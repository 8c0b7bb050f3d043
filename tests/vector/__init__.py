"""Vector output."""
