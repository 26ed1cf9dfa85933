"""Numbers about a surface: samples, integrals, extremes, summaries, tables."""
