"""The source's parts, tables and errata, as data and code."""
