"""Exact numbers, angles and arcs: the floor everything else stands on."""
