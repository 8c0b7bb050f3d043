"""Tests of sketchkit.geometry."""
