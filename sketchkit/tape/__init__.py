"""Tapes: what a sketch has drawn, call by call, as bytes that another process can draw again.

A tape holds plain data alone. Whoever plays one runs nothing of the sketch: so a stranger's sketch
can be drawn, and looked into, where it cannot reach.
"""
