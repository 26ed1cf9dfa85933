"""Making a shape: what the shape parameters do to it."""
