"""Errors in words for someone who is learning to program: a file for each family of them."""
