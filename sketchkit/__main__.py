"""`python -m sketchkit` is the command `sketchkit`."""

from sketchkit.cli.main import main

main()
