"""Plots of columns over time, over the load factor, or over another column."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, TypeAlias, overload

import numpy as np

from ancf.display.numbers import with_unit
from ancf.graphics.shapes import Grid, ShapePlots
from ancf.graphics.style import grid, style
from ancf.record.columns import ENERGIES, JOINT_COORDINATES, VECTORS, Array
from ancf.record.suggestion import unknown_name
from ancf.record.views import Probe

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from matplotlib.axes import Axes

    from ancf.record.result_data import ResultData

Curves: TypeAlias = "Mapping[str, Array]"
"""Columns by their labels."""

QUANTITIES = {column: name.replace("_", " ") for name, columns in VECTORS.items() for column in columns}
"""Quantities of the columns of vectors, by suffix."""

KINEMATIC = {"position", "angle", "displacement", "length"}
"""Quantities that are plotted on the horizontal axis, with the load factor on the vertical axis."""

MAX_MARKED_ROWS = 60
"""Maximum number of rows with a marker each, if the analysis chooses the rows."""

ROUNDING = 1e-9
"""Curves below this fraction of the largest value are zero."""

MAX_INNER_LEGEND = 4
"""Maximum number of curves with the legend inside the axes."""


class CurvePlots(ShapePlots):
    """Plots of columns."""

    @overload
    def plot(self) -> Grid: ...

    @overload
    def plot(
        self,
        *names: str,
        x: str | None = None,
        ax: Axes | None = None,
        subplots: Literal[False] = False,
        **line: object,
    ) -> Axes: ...

    @overload
    def plot(
        self, *names: str, x: str | None = None, ax: None = None, subplots: Literal[True], **line: object
    ) -> Grid: ...

    @overload
    def plot(
        self,
        *names: str,
        x: str | None = None,
        ax: Axes | None = None,
        subplots: bool = False,
        **line: object,
    ) -> Axes | Grid: ...

    def plot(
        self,
        *names: str,
        x: str | None = None,
        ax: Axes | None = None,
        subplots: bool = False,
        **line: object,
    ) -> Axes | Grid:
        """Plot columns over time, the load factor over displacements, or values over the number of the mode.

        Returns the axes, several with `subplots` or without names. Estimated errors are bands: value ± error.

        Parameters
        ----------
        *names
            Columns; probes, whose positions are plotted; joints; vectors such as `tip.velocity`; `energy`.
            Without names an overview: displacements of probes since the first row, and energies; or all modes.
        x
            The column of the horizontal axis, instead of time, load factor or mode.
        ax
            Axes to plot in; new ones by default.
        subplots
            True for separate axes for each name, or for each column of a single name.
        **line
            Properties of the lines, such as `linestyle="--"`.

        """
        if not names:
            return self.plot_modes() if self.is_modal else _overview(self)
        curves = {name: columns(self, name) for name in names}
        if not subplots:
            together = {label: column for own in curves.values() for label, column in own.items()}
            return _draw(self, together, x, ax, line)
        if ax is not None:
            msg = "plot: found ax= and subplots=True, expected one of them"
            raise ValueError(msg)
        return _stacked(self, list(curves.values()), x, line)


def _stacked(result: ResultData, groups: list[Curves], x: str | None, line: dict[str, Any]) -> Grid:
    """Plot each group, or each column of a single group, in axes of its own."""
    import matplotlib.pyplot as plt

    if len(groups) == 1:
        groups = [{label: column} for label, column in groups[0].items()]
    beside = all(_has_vertical_load(result, x, group) for group in groups)
    count = len(groups)
    with style():
        if beside:
            _, axes = plt.subplots(1, count, figsize=(3.2 * count, 4), squeeze=False, sharey=True)
        else:
            _, axes = plt.subplots(count, 1, figsize=(6.4, 1 + 1.7 * count), squeeze=False)
    for ax, group in zip(axes.flat, groups, strict=True):
        _draw(result, group, x, ax, line)
        if beside:
            ax.label_outer()
            ax.locator_params(axis="x", nbins=4)
    if not beside and not any(_has_vertical_load(result, x, group) for group in groups):
        for ax in axes.flat[:-1]:
            ax.sharex(axes.flat[-1])
            ax.label_outer()
    return axes.ravel()


def _has_vertical_load(result: ResultData, x: str | None, curves: Iterable[str]) -> bool:
    """Return True if the load factor is on the vertical axis, as in load-displacement curves."""
    return (
        x is None
        and result.kind in {"statics", "path"}
        and all(quantity(label) in KINEMATIC for label in curves)
    )


def _draw(
    result: ResultData, curves: Curves, x: str | None, ax: Axes | None, line: dict[str, Any], what: str = ""
) -> Axes:
    """Plot curves in one pair of axes. Their quantity is that of the columns unless `what` is given."""
    import matplotlib.pyplot as plt

    if result.is_modal and x is None:
        line = {"linestyle": "none", "marker": "o"} | line
    elif result.kind in {"statics", "path"} and len(result) <= MAX_MARKED_ROWS:
        line = {"marker": "o"} | line
    over, numbers = _abscissa(result, x)
    up = _has_vertical_load(result, x, curves)
    with style():
        if ax is None:
            _, ax = plt.subplots(figsize=(7.4, 4.4) if len(curves) > MAX_INNER_LEGEND else None)
        if not ax.has_data():
            grid(ax)
        for label, column in curves.items():
            pair = (column, numbers) if up else (numbers, column)
            (curve,) = ax.plot(*pair, **{"label": label} | line)
            if f"{label}_error" in result:
                _band(ax, numbers, column, abs(result[f"{label}_error"]), curve.get_color(), up=up)
        what = with_unit(what or _common_quantity(list(curves)), _common_unit(result, curves))
        ax.set_xlabel(what if up else over)
        ax.set_ylabel(over if up else what)
        if len(curves) > MAX_INNER_LEGEND:
            ax.legend(loc="center left", bbox_to_anchor=(1, 0.5))
        elif len(curves) > 1 or "label" in line:
            ax.legend()
    return ax


def _band(ax: Axes, numbers: Array, column: Array, error: Array, color: object, *, up: bool) -> None:
    """Fill the band of the estimated error of a curve."""
    fill = ax.fill_betweenx if up else ax.fill_between
    fill(numbers, column - error, column + error, color=color, alpha=0.25, linewidth=0)


def _abscissa(result: ResultData, x: str | None) -> tuple[str, Array]:
    """Return label and numbers of the column over which others are plotted."""
    if x is None:
        words = {"t": "time", "load": "load factor"}
        first = result.columns[0]
        return with_unit(words.get(first, first), result.units.get(first)), result.data[:, 0]
    found = columns(result, x)
    if len(found) != 1:
        msg = f"x: found {x!r}, which has {', '.join(map(repr, found))}; expected one column"
        raise ValueError(msg)
    (label, numbers), *_ = found.items()
    return with_unit(label, _common_unit(result, found)), numbers


def _common_quantity(labels: list[str]) -> str:
    """Return the name of a single column, or the common quantity of several, if any."""
    if len(labels) == 1:
        return labels[0]
    found = {quantity(label) for label in labels}
    return found.pop() if len(found) == 1 else ""


def _common_unit(result: ResultData, labels: Iterable[str]) -> str | None:
    """Return the common unit of columns, if any."""
    # The total energy is not a column.
    found = {result.units.get("strain" if label == "total" else label) for label in labels}
    return found.pop() if len(found) == 1 else None


def quantity(column: str) -> str:
    """Return the quantity of a column by the suffix of its name."""
    _, dot, suffix = column.rpartition(".")
    if not dot:
        return "energy" if column in {*ENERGIES, "total"} else column
    return QUANTITIES.get(suffix, suffix)


def columns(result: ResultData, name: str) -> dict[str, Array]:
    """Return the columns of a name: a column, the vector of a probe or a joint, or all energies."""
    if name in result:
        return {name: result[name]}
    if name in {"energy", "total"}:
        return _energies(result, name)
    holder, _, vector = name.rpartition(".")
    chosen = [(holder, VECTORS[vector])] if holder and vector in VECTORS else []
    chosen += [(name, (suffix,)) for suffix in JOINT_COORDINATES if suffix not in {"rate", "speed"}]
    chosen += [(name, VECTORS[each]) for each in (*Probe.QUANTITIES, "force")]
    for whose, suffixes in chosen:
        labels = [f"{whose}.{suffix}" for suffix in suffixes]
        if all(label in result for label in labels):
            return {label: result[label] for label in labels}
    within = {column: result[column] for column in result.columns if column.startswith(f"{name}.")}
    if not within:
        known = dict.fromkeys(column.rpartition(".")[0] for column in result.columns if "." in column)
        raise KeyError(unknown_name("column, probe or joint", name, [*result.columns, *known, "energy"]))
    return within


def _energies(result: ResultData, name: str) -> dict[str, Array]:
    """Return all energies that are not zero, or the total energy. Kinetic energy is omitted in statics."""
    if "strain" not in result:
        msg = f"{name}: found a result of {result.kind} without energies, expected one that has them"
        raise ValueError(msg)
    total = {"total": result.energy.total}
    if name == "total":
        return total
    omitted = {"kinetic"} if result.kind in {"statics", "path"} else set()
    own = {column: result[column] for column in ENERGIES if column in result and column not in omitted}
    return {**_not_zero(own), **total}


def _not_zero(curves: Mapping[str, Array]) -> dict[str, Array]:
    """Return the curves that are not zero up to rounding errors, or all if there are no others."""
    sizes = {label: np.nanmax(np.abs(column), initial=0.0) for label, column in curves.items()}
    least = ROUNDING * max(sizes.values(), default=0.0)
    return {label: column for label, column in curves.items() if sizes[label] > least} or dict(curves)


def _overview(result: ResultData) -> Grid:
    """Plot the displacements of probes since the first row, and the energies."""
    import matplotlib.pyplot as plt

    moved = [name for name in result.probes if f"{name}.x" in result]
    count = len(moved) + 1
    wide = 2 if count > 2 else 1
    high = -(-count // wide)
    with style():
        _, axes = plt.subplots(high, wide, figsize=(5.2 * wide + 1.4, 2.3 * high + 0.6), squeeze=False)
    for ax in axes.flat[count:]:
        ax.remove()
    for ax, name in zip(axes.flat, moved, strict=False):
        path = {f"{name}.{axis}": result[f"{name}.{axis}"] for axis in "xyz"}
        displacements = _not_zero({label: x - x[0] for label, x in path.items()})
        # Without a legend, the label has the only component.
        along = f" along {next(iter(displacements))[-1]}" if len(displacements) == 1 else ""
        _draw(result, displacements, None, ax, {}, f"displacement of {name}{along}")
    _draw(result, columns(result, "energy"), None, axes.flat[count - 1], {})
    return axes.ravel()[:count]
