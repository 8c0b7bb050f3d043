"""Tests of sketchkit.glsl."""
