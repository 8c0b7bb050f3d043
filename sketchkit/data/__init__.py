"""Text and tables: independent of drawing."""
