"""Artists of matplotlib for lines, arms and values of bodies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.graphics.style import ARM_GREY, COLOURS, GREY, SUPPORT_GREY, colour_map

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from ancf.graphics.lines import Lines
    from ancf.graphics.view import Canvas, View
    from ancf.record.columns import Array

SHELL_LINE = 0.9
"""Width of the edges of shell elements."""

TRIANGLE_BELOW = 6
"""Marker of matplotlib: a triangle whose upper corner is the point."""


def body_colours(lines: Lines, color: str | None) -> list[str]:
    """Return the colour of each body."""
    if color is not None:
        return [color] * len(lines.bodies)
    if len(lines.bodies) > len(COLOURS):
        return [COLOURS[0]] * len(lines.bodies)
    return list(COLOURS[: len(lines.bodies)])


def draw_lines(
    ax: Canvas, view: View, lines: Lines, positions: Array, colours: list[str], look: dict[str, Any]
) -> list[Any]:
    """Draw a line for each beam and cable, the edges of the elements of each shell, and a dot for each rigid body."""
    drawn = []
    paths = lines.polylines(view.coordinates(positions))
    for name, path, colour in zip(lines.bodies, paths, colours, strict=True):
        marker = {"marker": "o"} if len(path) == 1 else {}
        width = {"linewidth": SHELL_LINE} if name in lines.grids else {}
        keys = {"label": name, "color": colour, "linestyle": "-"} | width | marker | look
        drawn.extend(ax.plot(*path.T, **keys))
    return drawn


def draw_reference(ax: Canvas, view: View, lines: Lines, positions: Array) -> None:
    """Draw thin grey lines of the reference configuration."""
    draw_lines(ax, view, lines, positions, [GREY] * len(lines.bodies), {"linewidth": 1, "zorder": 1})


def draw_arms(
    ax: Canvas, view: View, lines: Lines, row: int, positions: Array, look: dict[str, Any]
) -> Canvas:
    """Draw the arms of rigid bodies as one artist with gaps."""
    keys = {"color": ARM_GREY, "linewidth": 3.0, "linestyle": "-", "zorder": 1.5, "label": "_arms"}
    return ax.plot(*arm_coordinates(view, lines, row, positions), **keys, **alpha(look))[0]


def arm_coordinates(view: View, lines: Lines, row: int, positions: Array) -> Array:
    """Return the coordinates of the arms, `[axis, point]`, with a gap after each arm."""
    tips = lines.arms.tips(row, positions)
    ends = np.stack([positions[lines.arms.stations], tips, np.full_like(tips, np.nan)], axis=1)
    coordinates: Array = view.coordinates(ends).reshape(-1, len(view.basis)).T
    return coordinates


def draw_values(
    ax: Canvas,
    view: View,
    lines: Lines,
    positions: Array,
    values: Array,
    colours: tuple[str, tuple[float, float]],
    look: dict[str, Any],
) -> Canvas:
    """Draw the lines and shells of all bodies in the colours of values, by a colour map and its limits.

    A segment has the mean value of its ends, a cell that of its corners.
    """
    seen = view.coordinates(positions)
    for stations in lines.bodies.values():
        if stations.stop - stations.start == 1:
            ax.plot(*seen[stations].T, **{"marker": "o", "color": ARM_GREY} | alpha(look))
    firsts = lines.segments
    common = {"cmap": colour_map(colours[0]), "clim": colours[1], **alpha(look)}
    drawn = None
    if len(lines.cells):
        drawn = _draw_cells(ax, view, lines, positions, values, common)
    if len(firsts):
        keys = common | {
            "array": (values[firsts] + values[firsts + 1]) / 2,
            "linewidths": look.get("linewidth", 3.0),
            "capstyle": "round",
        }
        drawn = _collection(ax, view, np.stack([seen[firsts], seen[firsts + 1]], axis=1), keys)
    return drawn


def _draw_cells(
    ax: Canvas, view: View, lines: Lines, positions: Array, values: Array, keys: dict[str, Any]
) -> Canvas:
    """Draw the cells of shells as one artist, in a plane the nearest ones last."""
    from matplotlib.collections import PolyCollection
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection  # type: ignore[import-untyped]

    cells = lines.cells
    if not view.spatial:
        depth = positions[cells].mean(axis=1) @ np.cross(*view.basis)
        cells = cells[np.argsort(depth)]
    seen = view.coordinates(positions)[cells]
    # Without antialiasing, faces have no gaps between them.
    keys = keys | {"array": values[cells].mean(axis=1), "linewidths": 0.0, "antialiaseds": False}
    if view.spatial:
        return ax.add_collection3d(Poly3DCollection(seen, **keys))
    return ax.add_collection(PolyCollection(list(seen), **keys))


def _collection(ax: Canvas, view: View, segments: Array, keys: dict[str, Any]) -> Canvas:
    """Draw segments `[segment, end, axis]` as one artist."""
    from matplotlib.collections import LineCollection
    from mpl_toolkits.mplot3d.art3d import Line3DCollection

    if view.spatial:
        return ax.add_collection3d(Line3DCollection(segments, **keys))
    return ax.add_collection(LineCollection(list(segments), **keys))


def draw_joints(
    ax: Canvas, view: View, lines: Lines, joints: Sequence[Any], row: int, scale: float | None
) -> None:
    """Draw joints as circles, joints on the ground as triangles, and clamps on the ground as squares."""
    positions = lines.symbols(row, scale)["joint"]
    groups: dict[Any, list[Array]] = {}
    for joint in joints:
        if joint["name"] in positions:
            groups.setdefault(joint_marker(joint), []).append(positions[joint["name"]])
    for marker, points in groups.items():
        fill = "white" if marker == "o" else SUPPORT_GREY
        keys = {"linestyle": "none", "marker": marker, "markersize": 5 if marker == "o" else 8, "zorder": 4}
        colours = {"markerfacecolor": fill, "markeredgecolor": "#303030", "markeredgewidth": 0.8}
        ax.plot(*view.coordinates(np.array(points)).T, **keys, **colours, label="_joints")


def joint_marker(joint: Mapping[str, Any]) -> str | int:
    """Return the marker of a joint: a circle, or on the ground a square for a clamp and else a triangle below."""
    other = joint.get("b", "ground")
    if other != "ground":
        return "o"
    return "s" if joint["kind"] in {"clamp", "drive"} else TRIANGLE_BELOW


def alpha(look: dict[str, Any]) -> dict[str, Any]:
    """Return the opacity among the properties of a line."""
    return {"alpha": look["alpha"]} if "alpha" in look else {}


def draw_legend(ax: Canvas, lines: Lines, *, beside: bool = True) -> None:
    """Draw the names of the bodies beside the axes, or in the axes if the caller owns the figure."""
    if not 1 < len(lines.bodies) <= len(COLOURS):
        return
    handles = {line.get_label(): line for line in ax.get_lines()}
    chosen = [handles[name] for name in lines.bodies]
    if beside:
        ax.figure.legend(chosen, list(lines.bodies), loc="outside right upper", fontsize="small")
    else:
        ax.legend(chosen, list(lines.bodies))
