"""The student's surface: Processing's names, thin and documented."""
