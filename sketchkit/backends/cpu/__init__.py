"""Draws with NumPy alone, for machines without OpenGL and for comparison."""

from sketchkit.backends.cpu.executor import CpuBackend

__all__ = ["CpuBackend"]
