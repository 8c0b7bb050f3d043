"""Reports: what grading has found out, as pages for people and as files for programs."""
