"""The text of ``stochgeom --version``."""

from importlib.metadata import PackageNotFoundError, version

try:
    VERSION_TEXT = f"stochgeom {version('stochgeom')}"
except PackageNotFoundError:  # a checkout that is not installed
    VERSION_TEXT = "stochgeom (not installed)"
