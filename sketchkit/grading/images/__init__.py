"""Whether two pictures are alike, where they are not, and why."""
