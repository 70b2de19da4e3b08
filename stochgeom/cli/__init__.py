"""The `stochgeom` command."""
