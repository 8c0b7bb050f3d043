"""Tests of sketchkit.core."""
