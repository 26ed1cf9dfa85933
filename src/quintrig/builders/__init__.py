"""New patches from those of a model: mirrored, extended, blended, filled, capped, and through a grid of points."""
