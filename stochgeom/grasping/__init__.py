"""Grasping with friction: what a pair of jaws makes of a part that may wedge (thesis ch. 3)."""
