"""Values and state: no drawing, no input or output."""
