"""Exchange with other programs: exact CAD files, meshes that carry curvature, flat patterns, control nets.

``export.export`` writes a model in the format of a file's suffix, ``formats`` lists them; ``imports.open_model`` reads
one. Every heavy package is imported where it is used, and an error names the extra to install when it is missing.
"""
