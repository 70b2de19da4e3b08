"""Reading and writing: text in, exact numbers out, and no geometry.

`stochgeom.io.outlines` reads a polygonal outline from JSON, WKT or plain lines. Every number is
read from its text, never through a float. Whether the outline is a polygon at all is decided by
the geometry layer.
"""
