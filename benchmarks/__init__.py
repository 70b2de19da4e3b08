"""Benchmarks: what stochgeom costs, measured beside what it is compared with.

``python -m benchmarks --list`` names them; README.md holds the figures and how they were got.
"""
