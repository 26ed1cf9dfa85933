"""Benchmarks: speed as ratios in one run against stated rivals, and accuracy against exact values."""
