"""Families of scalar functions on [0, 1]: what the rows and the blend of every surface are made of."""
