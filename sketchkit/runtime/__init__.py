"""A sketch alive: loading, looping, the window, errors."""
