"""Pictures, in two roads from one description: matplotlib `Axes`, and SVG text without it."""
