"""Developable strips: rulings, edges of regression, flat patterns."""
