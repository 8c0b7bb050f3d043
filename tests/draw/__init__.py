"""Tests of sketchkit.draw."""
