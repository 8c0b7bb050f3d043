"""Tests of sketchkit.api."""
