"""What surely contains a surface or its curvature: convex hulls."""
