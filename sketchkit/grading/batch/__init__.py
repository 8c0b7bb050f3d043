"""A class, submission by submission: what is run, kept, taken up again, and by whom."""
