"""Pure functions: numbers in, arrays out."""
