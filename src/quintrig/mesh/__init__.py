"""Triangle meshes of models."""

from quintrig.mesh.triangulate import mesh as mesh
