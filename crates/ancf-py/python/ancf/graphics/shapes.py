"""Plots of configurations and of mode shapes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ancf.graphics.artists import (
    body_colours,
    draw_arms,
    draw_joints,
    draw_legend,
    draw_lines,
    draw_reference,
    draw_values,
)
from ancf.graphics.frames import elastic_modes, frame_label, frame_numbers, require_int
from ancf.graphics.lines import Lines, drawn_parts
from ancf.graphics.quantities import Quantity, quantity
from ancf.graphics.style import COLOURS, style
from ancf.graphics.view import View
from ancf.record.result_data import ResultData

if TYPE_CHECKING:
    from collections.abc import Iterable

    from matplotlib.axes import Axes

Grid: TypeAlias = "np.ndarray[Any, np.dtype[Any]]"
"""Several axes of matplotlib."""


class ShapePlots(ResultData):
    """Plots of configurations and of mode shapes."""

    def plot_shape(
        self,
        frame: int | Iterable[int] = -1,
        *,
        time: float | Iterable[float] | None = None,
        plane: str | None = None,
        color: str | None = None,
        scale: float | None = None,
        reference: bool = True,
        joints: bool = True,
        parts: int = 8,
        ax: Axes | None = None,
        **line: object,
    ) -> Axes:
        """Plot the configuration in one row or in several. Earlier configurations are fainter.

        Parameters
        ----------
        frame
            Number of a row or of several, from the end if negative; modes are rows too. For a result of
            `ancf.load`, numbers of the kept states, `Result.frames`.
        time
            A time or several, instead of `frame`; the closest states are plotted.
        plane
            Two letters such as `xz`, the first to the right, or `3d`; by default the plane of the model.
        color
            A colour, or the quantity to colour by: `stress`, `axial_stress`, `shear_stress`, `bending_moment` and the
            other fields of the report, see `field`; components such as `Mz`, `exx`, `sxx`, `suu_top`; `displacement`,
            `velocity`, `acceleration`, or components such as `displacement.y`.
        scale
            Factor of deflections; by default 1, for modes chosen automatically.
        reference
            True to plot the reference configuration in grey.
        joints
            True to plot joints and supports in the last of the rows.
        parts
            Number of segments per element, fewer for shells with many elements.
        ax
            Axes to plot in; new ones by default.
        **line
            Properties of the lines, such as `linewidth=3`.

        """
        parts = drawn_parts(self, parts)
        lines = Lines(self, parts)
        shown = frame_numbers(self, frame, time)
        positions = [lines.positions(row, scale) for row in shown]
        points = [lines.points(row, own) for row, own in zip(shown, positions, strict=True)]
        extent = np.concatenate([*points, lines.reference] if reference else points)
        view = View.of(plane, extent, ax)
        found = _quantity(self, lines, color, parts)
        with style():
            is_own_figure = ax is None
            ax = view.axes(ax, self.field_units.get("position"))
            if reference:
                draw_reference(ax, view, lines, lines.reference)
            opacities = np.linspace(0.25, 1, len(shown) + 1)[1:].tolist()
            for row, own, opacity in zip(shown, positions, opacities, strict=True):
                look = {"alpha": opacity} | line
                draw_arms(ax, view, lines, row, own, look)
                if found is None:
                    draw_lines(ax, view, lines, own, body_colours(lines, color), look)
                    continue
                limits = found.limits(found.values[shown])
                factor, label = found.scaled(limits)
                colours = (found.colour_map, (factor * limits[0], factor * limits[1]))
                bands = draw_values(ax, view, lines, own, factor * found.values[row], colours, look)
            if joints:
                draw_joints(ax, view, lines, self.model.get("joints", []), shown[-1], scale)
            view.fit(ax, extent)
            if found is not None:
                pad = 0.1 if view.spatial else 0.03
                ax.figure.colorbar(bands, ax=ax, label=label, shrink=0.8, pad=pad)
            elif color is None:
                draw_legend(ax, lines, beside=is_own_figure)
            labels = dict.fromkeys(frame_label(self, row) for row in (shown[0], shown[-1]))
            ax.set_title(" ... ".join(labels))
        return ax

    def plot_modes(
        self,
        count: int = 6,
        *,
        rigid: bool = False,
        plane: str | None = None,
        scale: float | None = None,
        parts: int = 8,
    ) -> Grid:
        """Plot the first modes or buckling shapes, each in axes of its own. Returns the axes.

        Parameters
        ----------
        count
            Number of modes.
        rigid
            True to include rigid-body modes, whose frequency is zero.
        plane
            Two letters such as `xz`, the first to the right, or `3d`; by default the plane of the modes. Modes of
            a straight line are each plotted in the plane of their largest deflection.
        scale
            Factor of the shapes; by default chosen automatically.
        parts
            Number of segments per element, fewer for shells with many elements.

        """
        import matplotlib.pyplot as plt

        parts = drawn_parts(self, parts)
        lines = Lines(self, parts)
        if not lines.modal:
            msg = f"a result of {self.kind} has no shapes"
            raise AttributeError(msg)
        require_int("count", count, 1)
        shown = (list(range(len(lines.path))) if rigid else elastic_modes(self))[:count]
        positions = [lines.positions(row, scale) for row in shown]
        straight = View.along(lines.path[0], positions[0] - lines.path[0]) if plane is None else None
        extent = np.stack([*positions, lines.path[0]])
        view = straight or View.of(plane, extent)
        columns = min(3, len(shown))
        rows = -(-len(shown) // columns)
        projection = {"projection": "3d"} if view.spatial else {}
        with style():
            size = (3.1 * columns, 2.9 * rows)
            _, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, subplot_kw=projection)
            for ax in axes.flat[len(shown) :]:
                ax.remove()
            for ax, row, own in zip(axes.flat, shown, positions, strict=False):
                path = lines.path[row]
                chosen = view if straight is None else View.along(path, own - path) or view
                draw_reference(ax, chosen, lines, path)
                draw_lines(ax, chosen, lines, own, [COLOURS[0]] * len(lines.bodies), {})
                chosen.fit(ax, extent, zoom=1.15)
                ax.set_title(frame_label(self, row))
                chosen.remove_labels(ax)
        return axes.ravel()[: len(shown)]


def _quantity(result: ResultData, lines: Lines, color: str | None, parts: int) -> Quantity | None:
    """Return the quantity to colour by, or None if `color` is a colour."""
    from matplotlib.colors import is_color_like

    if color is None or is_color_like(color):
        return None
    if not len(lines.segments) and not len(lines.cells):
        msg = f"color: found {color!r}, expected a colour, since there is no beam, cable or shell"
        raise ValueError(msg)
    return quantity(result, color, parts)
