"""Pictures as arrays: (h, w, 4) uint8, RGBA of straight alpha. Pure functions, as in `geometry`."""
