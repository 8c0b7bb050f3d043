"""What a sketch of Processing's Python Mode finds around it: names, modules, and Java."""
