"""Fixers of our own for the library that converts: its names are those that it looks for."""
