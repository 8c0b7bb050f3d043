"""Checks: what a submission has shown against what its assignment asks for, in marks and words."""
