"""The matplotlib road: scenes and functions on `Axes`.  Needs the extra ``plot``.

Functions take the axes to draw on and return them; without any they make a figure of their own
that fits. Files are written by `save_figure`, the same bytes each time.
"""

from __future__ import annotations

import os
import warnings
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from stochgeom.arguments import expect
from stochgeom.errors import InputError, MissingExtraError
from stochgeom.io.files import write_whole
from stochgeom.plotting.scene import Disc, Label, Line, Scene, Shape
from stochgeom.plotting.styles import INK, STYLES, Style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FORMATS: Final = ("pdf", "png", "svg")
"""What figures are saved as."""

# Without dates and version numbers, which would differ from one run to the next.
_METADATA: Final[dict[str, dict[str, Any]]] = {
    "svg": {"Date": None, "Creator": "stochgeom"},
    "png": {"Software": None},
    "pdf": {"CreationDate": None, "Creator": "stochgeom", "Producer": None},
}

PIXEL: Final = 1 / 80
"""Inches of a unit of scenes that are drawn in pixels."""

_LARGEST_INCHES: Final = 40.0

_SMALLEST_LETTERS: Final = 2.5
_LEGIBLE_LETTERS: Final = 6.0
"""In points."""

_CALLER: Final = 4
"""How far above the warning the code stands that called a drawing function."""


def need_matplotlib() -> None:
    """Raise what says how matplotlib is installed, if it is not."""
    try:
        import matplotlib  # noqa: F401
    except ImportError:
        raise MissingExtraError.of("pictures on axes", "matplotlib", "plot") from None


def axes_or_new(ax: Axes | None, size: tuple[float, float] = (6.4, 4.0)) -> Axes:
    """Return axes as they are, or those of a new figure of that many inches.

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.
    InputError
        If something else than axes was given.
    """
    need_matplotlib()
    if ax is None:
        import matplotlib.pyplot as plt

        width, height = (min(max(side, 1.0), _LARGEST_INCHES) for side in size)
        return plt.subplots(figsize=(width, height), layout="constrained")[1]
    from matplotlib.axes import Axes

    return expect(ax, Axes, "the Axes of matplotlib, or None for new ones")


def draw_scene(scene: Scene, ax: Axes | None = None, *, inches: float = 0.3) -> Axes:
    """Draw a scene on axes: equal scales, no frame, everything inside.

    Parameters
    ----------
    scene : Scene
        What is drawn.
    ax : Axes, optional
        Default: those of a new figure.
    inches : float
        Of one unit in a new figure.

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.

    Warns
    -----
    UserWarning
        If letters would be too small to be read; it says how large the axes would have to be.

    Notes
    -----
    Letters have the size that fits the axes as they are when this is called: resize first.
    """
    left, bottom, right, top = scene.bounds()
    pad = 0.02 * max(right - left, top - bottom)
    size = ((right - left + 2 * pad) * inches, (top - bottom + 2 * pad) * inches)
    own = ax is None
    ax = axes_or_new(ax, size)
    ax.set(xlim=(left - pad, right + pad), ylim=(bottom - pad, top + pad))
    ax.set_aspect("equal")
    ax.axis("off")
    points = _points_per_unit(ax)
    _warn_of_small_letters(scene, ax, points, own=own)
    for order, shape in enumerate(scene.shapes):
        _draw(ax, shape, points, 2 + order * 1e-4)
    return ax


def _points_per_unit(ax: Axes) -> float:
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    box = ax.get_window_extent()
    pixels = min(box.width / (right - left), box.height / (top - bottom))
    return float(pixels * 72.0 / ax.get_figure(root=True).dpi)  # type: ignore[union-attr]


def _warn_of_small_letters(scene: Scene, ax: Axes, points: float, *, own: bool) -> None:
    sizes = [shape.size for shape in scene.shapes if isinstance(shape, Label)]
    smallest = min(sizes, default=1e9) * points
    if smallest < _SMALLEST_LETTERS:
        (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
        inches = _LEGIBLE_LETTERS / min(sizes) / 72.0
        width, height = (right - left) * inches, (top - bottom) * inches
        warnings.warn(
            f"letters of {smallest:.1f} points are too small to be read; the picture needs axes of "
            f"about {width:.1f} by {height:.1f} inches" + ", or a figure of its own" * (not own),
            stacklevel=_CALLER,
        )


def _draw(ax: Axes, shape: Shape, points: float, order: float) -> None:
    from matplotlib import patches
    from matplotlib.lines import Line2D

    if isinstance(shape, Label):
        ax.text(
            *shape.at,
            shape.text,
            fontsize=shape.size * points,
            ha={"start": "left", "middle": "center", "end": "right"}[shape.anchor],
            va="center_baseline",
            weight="bold" if shape.bold else "normal",
            color=INK,
            zorder=order,
            parse_math=False,
        )
        return
    style = STYLES[shape.style]
    if isinstance(shape, Line):
        xs, ys = zip(*shape.points, strict=True)
        line = Line2D(xs, ys, color=style.stroke, linewidth=style.width, zorder=order)
        line.set_linestyle(_dashes(style))
        line.set_solid_joinstyle("round")
        ax.add_line(line)
        return
    look: dict[str, Any] = {
        "facecolor": style.fill or "none",
        "edgecolor": style.stroke or "none",
        "linewidth": style.width if style.stroke else 0.0,
        "linestyle": _dashes(style),
        "zorder": order,
    }
    if isinstance(shape, Disc):
        ax.add_patch(patches.Circle(shape.center, shape.radius, **look))
    else:
        ax.add_patch(patches.Polygon(shape.points, closed=True, joinstyle="round", **look))


def _dashes(style: Style) -> Any:
    if not style.dash:
        return "-"
    return (0, tuple(length / style.width for length in style.dash))


def save_figure(
    picture: Axes | tuple[Axes, ...] | Figure, path: str | os.PathLike[str], *, dpi: int = 200
) -> Path:
    """Write the figure of a picture: the same bytes every time, whole or not at all.

    The bytes do not depend on what the figure was saved as before.

    Parameters
    ----------
    picture : Axes, tuple of Axes, or Figure
        What a drawing function returned.
    path : path
        Ending in ``.svg``, ``.pdf`` or ``.png``.
    dpi : int
        Dots per inch of a PNG.

    Raises
    ------
    InputError
        For any other ending.
    WriteError
        If the file cannot be written; what stood there still does.

    Examples
    --------
    >>> import tempfile
    >>> from matplotlib.figure import Figure
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     written = save_figure(Figure(), Path(folder) / "empty.svg")
    >>> written.name
    'empty.svg'
    """
    need_matplotlib()
    import matplotlib

    target = Path(expect(path, str | os.PathLike, "text, or a pathlib.Path", "path"))
    kind = target.suffix.removeprefix(".").lower()
    if kind not in FORMATS:
        accepted = ", ".join(f".{name}" for name in FORMATS)
        raise InputError(f"a picture file that ends in {target.suffix!r}; accepted: {accepted}")
    # What draws several graphs returns the axes of all of them.
    one: Any = picture[0] if isinstance(picture, tuple) and picture else picture
    figure: Any = one.get_figure(root=True) if hasattr(one, "get_figure") else one
    if not hasattr(figure, "savefig"):
        raise InputError(f"{picture!r:.60} is no picture; accepted: Axes or a Figure of matplotlib")
    _forget_layout(figure)
    content = BytesIO()
    # The salt makes the names inside SVG files the same each time.
    with matplotlib.rc_context({"svg.hashsalt": "stochgeom", "svg.fonttype": "path"}):
        figure.savefig(content, format=kind, dpi=dpi, metadata=_METADATA[kind])
    write_whole(target, content.getvalue())
    return target


def _forget_layout(figure: Any) -> None:
    """Put axes back where they stood before a layout was computed, which depends on that.

    A figure that was saved with another number of dots per inch would else differ from a new one.
    """
    if figure.get_layout_engine() is None:
        return
    for ax in figure.axes:
        place = ax.get_subplotspec()
        if place is not None and ax.get_in_layout():
            ax.set_subplotspec(place)
