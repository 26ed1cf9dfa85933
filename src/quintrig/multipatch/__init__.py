"""Several patches: which edges they share."""
