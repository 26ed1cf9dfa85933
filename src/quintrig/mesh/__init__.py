"""Triangle meshes of models."""
