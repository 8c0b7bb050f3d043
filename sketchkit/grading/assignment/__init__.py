"""Assignments: a folder with `assignment.toml`, references and data, as plain values."""
