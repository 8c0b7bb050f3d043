"""Tests of sketchkit.data."""
