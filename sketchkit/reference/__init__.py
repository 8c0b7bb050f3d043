"""What Processing has: its names as data, and what to write for those that sketchkit has not."""
