"""Polygonal parts and the functions of orientation that their outlines define."""
