"""Each draws a finished draw list; none imports another."""
