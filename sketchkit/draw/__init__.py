"""The seam: what the API records and the backends draw."""
