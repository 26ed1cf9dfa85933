"""What can be read at a point of a surface: formulas, classes, and the one table of them all."""
