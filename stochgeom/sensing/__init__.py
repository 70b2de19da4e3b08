"""Sensors, posterior updates, and plans with sensors (thesis ch. 7)."""
