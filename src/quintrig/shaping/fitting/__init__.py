"""Fitting: surfaces and curves of every kind through measured points."""
