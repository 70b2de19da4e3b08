"""How values show themselves in notebooks, and write themselves as pages, without knowing how.

Pictures live at the far end of the package, values at the near one, and no layer imports from one
below it. So a value that has a rich display says only *that* it has one, by inheriting from
`Displayed`; the facade registers where the renderers are; they are loaded when the first value is
displayed. A value without a renderer shows its `repr`.

Examples
--------
>>> from stochgeom.geometry.part import Part
>>> Part([(0, 0), (3, 0), (3, 2), (0, 2)])._repr_svg_()[:4]
'<svg'
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

Renderers = Mapping[tuple[str, str], Callable[..., Any]]
"""From the name of a class and a form such as ``"svg"`` to the function that makes it."""

_sources: list[Callable[[], Renderers]] = []


def register_renderers(source: Callable[[], Renderers]) -> None:
    """Name a function that returns renderers; it is called when the first value is displayed.

    Called once, by the facade.
    """
    _sources.append(source)


def render(value: object, form: str, *arguments: Any, **options: Any) -> Any:
    """Return a value in a form, None if nothing was registered that makes it.

    Parameters
    ----------
    value : object
        Its class, or the nearest of its bases that has a renderer, decides.
    form : str
        ``"svg"``, ``"html"``, ``"latex"``, ``"report"``.
    """
    for source in _sources:
        renderers = source()
        for owner in type(value).__mro__:
            renderer = renderers.get((owner.__name__, form))
            if renderer is not None:
                return renderer(value, *arguments, **options)
    return None


class Displayed:
    """A value with a rich display: what notebooks ask for, each None where there is none."""

    __slots__ = ()

    def _repr_svg_(self) -> str | None:
        picture: str | None = render(self, "svg")
        return picture

    def _repr_html_(self) -> str | None:
        page: str | None = render(self, "html")
        return page

    def _repr_latex_(self) -> str | None:
        formula: str | None = render(self, "latex")
        return formula
