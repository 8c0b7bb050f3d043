"""Draws with NumPy alone, for machines without OpenGL and for comparison."""
