"""Model files: kinds, reading, writing, messages, schema, starters."""
