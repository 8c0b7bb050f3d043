"""GLSL as text: what a shader declares, its dialect, and what is wrong with it."""
