"""The compiled driver: from rows and blend to quantities, in blocks of points."""
