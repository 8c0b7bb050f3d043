"""Table and TableRow."""
