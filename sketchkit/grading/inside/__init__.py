"""What runs behind the wall: `record` beside a stranger's code, `redraw` without it."""
