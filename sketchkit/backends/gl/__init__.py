"""Draws with OpenGL, through moderngl."""
