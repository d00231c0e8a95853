"""Pictures of where the bodies are: configurations and shapes of modes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ancf.lines import AXES, COLOURS, Lines, rows, shaking, told, whole, with_unit
from ancf.plot import Grid, grid, style
from ancf.record import Array

if TYPE_CHECKING:
    from collections.abc import Iterable

    from matplotlib.axes import Axes

    from ancf.result import Result

FLAT = 0.02
"""Extent off a plane, over the greatest one, up to which a picture is drawn in the plane."""

GREY = "#b8b8b8"
"""Colour of the reference configuration and of the arms of rigid bodies."""


Canvas: TypeAlias = "Any"
"""Axes of matplotlib, flat or in space; its types do not say what they have in common."""


class View:
    """A plane, by its horizontal and its vertical direction, or space."""

    def __init__(self, basis: Array, names: str) -> None:
        """The plane of two directions, `basis[2, 3]`, or space with three, and the names of coordinates."""
        self.basis, self.names = basis, names

    @classmethod
    def of(cls, plane: str | None, points: Array, ax: Canvas = None) -> View:
        """The named plane, such as `xy`, or that in which the points spread, or space if they leave it.

        If there are axes `ax` already, they say whether it is space.
        """
        if plane is None:
            spread = np.ptp(points.reshape(-1, 3), axis=0)
            spatial = spread.min() > FLAT * spread.max() if ax is None else hasattr(ax, "get_zlim")
            if spatial:
                return cls(np.eye(3), "xyz")
            # A straight line alone does not say which plane is meant.
            off = min(
                "zyx", key=lambda axis: round(spread[AXES[axis]] / spread.max(), 9) if spread.any() else 0
            )
            plane = "xyz".replace(off, "")
        if plane == "3d":
            return cls(np.eye(3), "xyz")
        if len(plane) != 2 or not set(plane) < set(AXES) or plane[0] == plane[1]:
            msg = f"plane: found {plane!r}, wanted two of the letters x, y, z, such as 'xz', or '3d'"
            raise ValueError(msg)
        return cls(np.eye(3)[[AXES[letter] for letter in plane]], plane)

    @classmethod
    def along(cls, line: Array, shape: Array) -> View | None:
        """The plane of a straight line and of most of what it deflects by; none if the line is bent."""
        sizes, axes = np.linalg.svd(line - line.mean(0), full_matrices=False)[1:]
        if sizes[1] > 1e-6 * sizes[0]:
            return None
        axis = axes[0] * np.sign(axes[0][np.abs(axes[0]).argmax()])
        across = shape - np.outer(shape @ axis, axis)
        normal = np.linalg.svd(np.vstack([across, 1e-9 * np.abs(shape).max() * np.eye(3)]))[2][0]
        # Numbers that are the same but for rounding give the same picture.
        normal = normal * np.sign(normal[np.abs(normal).round(6).argmax()])
        upright = abs(axis[0]) < 0.5
        return cls(np.stack([normal, axis] if upright else [axis, normal]), "  ")

    @property
    def spatial(self) -> bool:
        """Whether it is space."""
        return len(self.basis) == 3

    def seen(self, points: Array) -> Array:
        """Coordinates of points in the view."""
        coordinates: Array = points @ self.basis.T
        return coordinates

    def label(self, ax: Canvas, unit: str | None = None) -> None:
        """Name the axes, with the unit of length."""
        for name, own in zip("xyz", self.names, strict=False):
            getattr(ax, f"set_{name}label")(with_unit(own, unit) if own.strip() else own)

    def fit(self, ax: Canvas, points: Array, zoom: float = 0.82) -> None:
        """Show all points with the same scale along all axes; in space with room for their labels."""
        seen = self.seen(points.reshape(-1, 3))
        if not self.spatial:
            ax.set_aspect("equal", adjustable="datalim")
            ax.update_datalim(seen)
            ax.autoscale_view()
            return
        middle, half = (seen.max(0) + seen.min(0)) / 2, np.ptp(seen, axis=0) / 2
        half = 1.05 * np.maximum(half, 0.3 * half.max() or 1.0)
        for name, m, h in zip("xyz", middle, half, strict=True):
            getattr(ax, f"set_{name}lim")(m - h, m + h)
            axis = getattr(ax, f"{name}axis")
            axis.get_major_locator().set_params(nbins=max(2, int(5 * h / half.max())))
            axis.labelpad = 12 if name == "z" else 7
        ax.set_box_aspect(half, zoom=zoom)


def plot_shape(
    result: Result,
    frame: int | Iterable[int] = -1,
    *,
    time: float | Iterable[float] | None = None,
    plane: str | None = None,
    color: str | None = None,
    scale: float | None = None,
    reference: bool = True,
    parts: int = 8,
    ax: Axes | None = None,
    **line: object,
) -> Axes:
    """See `Result.plot_shape`."""
    lines = Lines(result, parts)
    wanted = rows(result, frame, time)
    places = [lines.places(row, scale) for row in wanted]
    reach = [lines.reach(row, place) for row, place in zip(wanted, places, strict=True)]
    extent = np.concatenate([*reach, lines.rest] if reference else reach)
    view = View.of(plane, extent, ax)
    values = mapped(result, lines, color, parts)
    with style():
        own = ax is None
        ax = axes_of(view, ax, result.field_units.get("position"))
        if reference:
            strokes(ax, view, lines, lines.rest, [GREY] * len(lines.bodies), {"linewidth": 1, "zorder": 1})
        for row, place, strength in zip(
            wanted, places, np.linspace(0.25, 1, len(wanted) + 1)[1:], strict=True
        ):
            look = {"alpha": float(strength)} | line
            arms(ax, view, lines, row, place, look)
            if values is None:
                strokes(ax, view, lines, place, body_colours(lines, color), look)
            else:
                bands = coloured(ax, view, lines, place, values[row], limits(values[wanted]), look)
        view.fit(ax, extent)
        if values is not None:
            ax.figure.colorbar(
                bands, ax=ax, label=named(result, color), shrink=0.8, pad=0.1 if view.spatial else 0.03
            )
        elif 1 < len(lines.bodies) <= len(COLOURS) and color is None:
            legend(ax, lines, beside=own)
        ax.set_title(" ... ".join(dict.fromkeys(told(result, row) for row in (wanted[0], wanted[-1]))))
    return ax


def plot_modes(
    result: Result,
    count: int = 6,
    *,
    rigid: bool = False,
    plane: str | None = None,
    scale: float | None = None,
    parts: int = 8,
) -> Grid:
    """See `Result.plot_modes`."""
    import matplotlib.pyplot as plt

    lines = Lines(result, parts)
    if not lines.modal:
        msg = f"a result of {result.kind} has no shapes"
        raise AttributeError(msg)
    whole("count", count, 1)
    wanted = (list(range(len(lines.path))) if rigid else shaking(result))[:count]
    places = [lines.places(row, scale) for row in wanted]
    straight = View.along(lines.path[0], places[0] - lines.path[0]) if plane is None else None
    view = straight or View.of(plane, np.stack([*places, lines.path[0]]))
    wide = min(3, len(wanted))
    high = -(-len(wanted) // wide)
    projection = {"projection": "3d"} if view.spatial else {}
    with style():
        size = (3.1 * wide, 2.9 * high)
        _, axes = plt.subplots(high, wide, figsize=size, squeeze=False, subplot_kw=projection)
        for ax in axes.flat[len(wanted) :]:
            ax.remove()
        for ax, row, place in zip(axes.flat, wanted, places, strict=False):
            own = view if straight is None else View.along(lines.path[row], place - lines.path[row]) or view
            strokes(ax, own, lines, lines.path[row], [GREY] * len(lines.bodies), {"linewidth": 1})
            strokes(ax, own, lines, place, [COLOURS[0]] * len(lines.bodies), {})
            own.fit(ax, np.stack([*places, lines.path[0]]), zoom=1.15)
            ax.set_title(told(result, row))
            bare(ax, own)
    return axes.ravel()[: len(wanted)]


def axes_of(view: View, ax: Canvas = None, unit: str | None = None) -> Canvas:
    """Axes for a view in a unit of length, new ones if there are none."""
    import matplotlib.pyplot as plt

    if ax is not None:
        pass
    elif view.spatial:
        _, ax = plt.subplots(subplot_kw={"projection": "3d"})
    else:
        _, ax = plt.subplots()
        grid(ax)
    view.label(ax, unit)
    return ax


def bare(ax: Canvas, view: View) -> None:
    """Take away what small pictures of shapes, which have no size of their own, do not need."""
    if view.spatial:
        view.label(ax)
        for name in "xyz":
            getattr(ax, f"set_{name}ticklabels")([])
            getattr(ax, f"{name}axis").labelpad = -12
    else:
        ax.set_axis_off()


def body_colours(lines: Lines, color: str | None) -> list[str]:
    """The colour of each body."""
    if color is not None:
        return [color] * len(lines.bodies)
    if len(lines.bodies) > len(COLOURS):
        return [COLOURS[0]] * len(lines.bodies)
    return list(COLOURS[: len(lines.bodies)])


def strokes(
    ax: Canvas, view: View, lines: Lines, places: Array, colours: list[str], look: dict[str, Any]
) -> list[Any]:
    """A line of each body, or a dot of a rigid one."""
    drawn = []
    seen = view.seen(places)
    for (name, stations), colour in zip(lines.bodies.items(), colours, strict=True):
        marker = {"marker": "o"} if stations.stop - stations.start == 1 else {}
        keys = {"label": name, "color": colour, "linestyle": "-"} | marker | look
        drawn.extend(ax.plot(*seen[stations].T, **keys))
    return drawn


def arms(ax: Canvas, view: View, lines: Lines, row: int, places: Array, look: dict[str, Any]) -> Canvas:
    """Lines from the centres of rigid bodies to their joints, as one with gaps."""
    keys = {"color": "#888888", "linewidth": 3.0, "linestyle": "-", "zorder": 1.5, "label": "_arms"}
    return ax.plot(*arms_at(view, lines, row, places), **keys, **alpha(look))[0]


def arms_at(view: View, lines: Lines, row: int, places: Array) -> Array:
    """Coordinates of the arms, `[axis, point]`, with a gap after each."""
    tips = lines.arms.tips(row, places)
    ends = np.stack([places[lines.arms.stations], tips, np.full_like(tips, np.nan)], axis=1)
    coordinates: Array = view.seen(ends).reshape(-1, len(view.basis)).T
    return coordinates


def coloured(
    ax: Canvas,
    view: View,
    lines: Lines,
    places: Array,
    values: Array,
    between: tuple[float, float],
    look: dict[str, Any],
) -> Canvas:
    """Lines of all bodies in the colours of values, which segments take from their middles."""
    seen = view.seen(places)
    for span in lines.bodies.values():
        if span.stop - span.start == 1:
            ax.plot(*seen[span].T, **{"marker": "o", "color": "#888888"} | alpha(look))
    firsts = lines.pieces
    middles = (values[firsts] + values[firsts + 1]) / 2
    keys = {
        "array": middles,
        "cmap": "coolwarm" if between[0] == -between[1] else "viridis",
        "clim": between,
        "linewidths": look.get("linewidth", 3.0),
        "capstyle": "round",
        **alpha(look),
    }
    return collection(ax, view, np.stack([seen[firsts], seen[firsts + 1]], axis=1), keys)


def collection(ax: Canvas, view: View, segments: Array, keys: dict[str, Any]) -> Canvas:
    """Segments `[segment, end, axis]` as one artist."""
    from matplotlib.collections import LineCollection
    from mpl_toolkits.mplot3d.art3d import Line3DCollection  # type: ignore[import-untyped]

    if view.spatial:
        return ax.add_collection3d(Line3DCollection(segments, **keys))
    return ax.add_collection(LineCollection(list(segments), **keys))


def alpha(look: dict[str, Any]) -> dict[str, Any]:
    """How opaque, of all that a look says."""
    return {"alpha": look["alpha"]} if "alpha" in look else {}


def mapped(result: Result, lines: Lines, color: str | None, parts: int) -> Array | None:
    """Values by which lines are coloured, `[row, station]`; none if `color` is a colour."""
    from matplotlib.colors import is_color_like

    if color is None or is_color_like(color):
        return None
    if not len(lines.pieces):
        msg = f"color: found {color!r}, wanted a colour, since there is no beam or cable"
        raise ValueError(msg)
    return lines.values(result, color, parts)


def named(result: Result, color: str | None) -> str:
    """What is coloured by, with its unit; shapes of modes have none."""
    unit = None if result.kind in {"modes", "buckling"} else str(color).partition(".")[0]
    return with_unit(str(color), result.field_units.get(unit or ""))


def limits(values: Array) -> tuple[float, float]:
    """Ends of a scale of colours, as far on both sides of zero if there are values on both."""
    known = values[np.isfinite(values)]
    least, greatest = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    far = max(abs(least), abs(greatest))
    if far == 0:
        return 0.0, 1.0
    # What is within a thousandth of zero is zero but for errors.
    least, greatest = (0.0 if abs(end) < 1e-3 * far else end for end in (least, greatest))
    return (-far, far) if least < 0 < greatest else (least, greatest)


def legend(ax: Canvas, lines: Lines, *, beside: bool = True) -> None:
    """Names of the bodies, in the axes or, if the figure is our own, beside them."""
    handles = {line.get_label(): line for line in ax.get_lines()}
    chosen = [handles[name] for name in lines.bodies]
    if beside:
        ax.figure.legend(chosen, list(lines.bodies), loc="outside right upper", fontsize="small")
    else:
        ax.legend(chosen, list(lines.bodies))
