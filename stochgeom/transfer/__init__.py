"""Transfer functions: step maps of the circle that actions induce on orientations."""
