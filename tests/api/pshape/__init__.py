"""Tests of sketchkit.api.pshape."""
