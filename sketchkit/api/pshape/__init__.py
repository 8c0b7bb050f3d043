"""PShape: drawings that are kept, edited and drawn often."""
