"""Curves of columns: over time, over the load factor, or over each other."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ancf.lines import COLOURS, with_unit
from ancf.record import FREEDOMS, VECTORS, Array, Probe, unknown

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Mapping

    from matplotlib.axes import Axes

    from ancf.result import Result

Curves: TypeAlias = "Mapping[str, Array]"
"""Columns by their labels."""

Grid: TypeAlias = "np.ndarray[Any, np.dtype[Any]]"
"""Several axes of matplotlib."""

QUANTITIES = {column: name.replace("_", " ") for name, columns in VECTORS.items() for column in columns}
"""What the columns of vectors are, by the ends of their names."""

ENERGIES = ("kinetic", "strain", "potential", "work", "dissipated", "balance")

MOVES = {"position", "angle", "displacement", "length"}
"""What is drawn to the right under a load that goes up."""

FEW = 60
"""Rows up to which each is marked by a dot, if the analysis chose them."""


CROWD = 4
"""Number of curves up to which their legend finds room between them."""


@contextmanager
def style() -> Iterator[None]:
    """The style of all pictures, for what is drawn within; nothing is changed for others."""
    import matplotlib.pyplot as plt
    from cycler import cycler

    settings: dict[Any, Any] = {
        "axes.axisbelow": True,
        "axes.edgecolor": "#777777",
        "axes.linewidth": 0.6,
        "axes.prop_cycle": cycler(linestyle=["-", "--", ":"]) * cycler(color=COLOURS),
        "axes.spines.right": False,
        "axes.spines.top": False,
        "axes.titlesize": "medium",
        "figure.constrained_layout.use": True,
        "legend.frameon": False,
        "legend.fontsize": "small",
        "lines.linewidth": 1.4,
        "lines.markersize": 3.5,
    }
    with plt.rc_context(settings):
        yield
        interactive = plt.isinteractive()
    # The first figure may have made a notebook show all that follow.
    plt.rcParams["interactive"] = interactive


def grid(ax: Axes) -> None:
    """Thin lines behind the curves."""
    ax.grid(visible=True, linewidth=0.4, color="#d5d5d5")


def plot(
    result: Result,
    *names: str,
    x: str | None = None,
    ax: Axes | None = None,
    subplots: bool = False,
    **line: object,
) -> Axes | Grid:
    """See `Result.plot`."""
    if not names:
        if result.kind in {"modes", "buckling"}:
            from ancf.shape import plot_modes

            return plot_modes(result)
        return overview(result)
    curves = {name: columns(result, name) for name in names}
    if not subplots:
        together = {label: column for own in curves.values() for label, column in own.items()}
        return draw(result, together, x, ax, line)
    if ax is not None:
        msg = "plot: found ax= and subplots=True, wanted one of them"
        raise ValueError(msg)
    return stacked(result, list(curves.values()), x, line)


def stacked(result: Result, groups: list[Curves], x: str | None, line: dict[str, Any]) -> Grid:
    """Axes above each other, for each name or, of a single name, for each column."""
    import matplotlib.pyplot as plt

    if len(groups) == 1:
        groups = [{label: column} for label, column in groups[0].items()]
    beside = all(upright(result, x, group) for group in groups)
    count = len(groups)
    with style():
        if beside:
            _, axes = plt.subplots(1, count, figsize=(3.2 * count, 4), squeeze=False, sharey=True)
        else:
            _, axes = plt.subplots(count, 1, figsize=(6.4, 1 + 1.7 * count), squeeze=False)
    for ax, group in zip(axes.flat, groups, strict=True):
        draw(result, group, x, ax, line)
        if beside:
            ax.label_outer()
            ax.locator_params(axis="x", nbins=4)
    if not beside and not any(upright(result, x, group) for group in groups):
        for ax in axes.flat[:-1]:
            ax.sharex(axes.flat[-1])
            ax.label_outer()
    return axes.ravel()


def upright(result: Result, x: str | None, curves: Iterable[str]) -> bool:
    """Whether the load factor goes up the vertical axis, as in curves of load and displacement."""
    moves = all(quantity(label) in MOVES for label in curves)
    return x is None and result.kind in {"statics", "path"} and moves


def draw(
    result: Result, curves: Curves, x: str | None, ax: Axes | None, line: dict[str, Any], what: str = ""
) -> Axes:
    """Curves in one pair of axes; `what` they measure is found out if it is not said."""
    import matplotlib.pyplot as plt

    if result.kind in {"modes", "buckling"} and x is None:
        line = {"linestyle": "none", "marker": "o"} | line
    elif result.kind in {"statics", "path"} and len(result) <= FEW:
        line = {"marker": "o"} | line
    over, numbers = abscissa(result, x)
    up = upright(result, x, curves)
    with style():
        if ax is None:
            _, ax = plt.subplots(figsize=(7.4, 4.4) if len(curves) > CROWD else None)
        if not ax.has_data():
            grid(ax)
        for label, column in curves.items():
            pair = (column, numbers) if up else (numbers, column)
            ax.plot(*pair, **{"label": label} | line)
        what = with_unit(what or measured(list(curves)), common(result, curves))
        ax.set_xlabel(what if up else over)
        ax.set_ylabel(over if up else what)
        if len(curves) > CROWD:
            ax.legend(loc="center left", bbox_to_anchor=(1, 0.5))
        elif len(curves) > 1 or "label" in line:
            ax.legend()
    return ax


def abscissa(result: Result, x: str | None) -> tuple[str, Array]:
    """Words and numbers of the axis that columns are drawn over."""
    if x is None:
        words = {"t": "time", "load": "load factor"}
        first = result.columns[0]
        return with_unit(words.get(first, first), result.units.get(first)), result.data[:, 0]
    found = columns(result, x)
    if len(found) != 1:
        msg = f"x: found {x!r}, which has {', '.join(map(repr, found))}; wanted one column"
        raise ValueError(msg)
    (label, numbers), *_ = found.items()
    return with_unit(label, common(result, found)), numbers


def measured(labels: list[str]) -> str:
    """What the columns of a plot measure: the one's name, the quantity that all are, or nothing."""
    if len(labels) == 1:
        return labels[0]
    found = {quantity(label) for label in labels}
    return found.pop() if len(found) == 1 else ""


def common(result: Result, labels: Iterable[str]) -> str | None:
    """The unit that all columns of a plot have, if they have one."""
    # The sum of energies is no column.
    found = {result.units.get("strain" if label == "total" else label) for label in labels}
    return found.pop() if len(found) == 1 else None


def quantity(column: str) -> str:
    """What a column measures, by the end of its name."""
    _, dot, end = column.rpartition(".")
    if not dot:
        return "energy" if column in {*ENERGIES, "total"} else column
    return QUANTITIES.get(end, end)


def columns(result: Result, name: str) -> dict[str, Array]:
    """The columns that a name means: its own, the vector of a probe or a joint, or all energies."""
    if name in result:
        return {name: result[name]}
    if name in {"energy", "total"} and "strain" not in result:
        msg = f"{name}: found a result of {result.kind} without energies, wanted one that has them"
        raise ValueError(msg)
    if name in {"energy", "total"}:
        still = {"kinetic"} if result.kind in {"statics", "path"} else set()
        own = {column: result[column] for column in ENERGIES if column in result and column not in still}
        total = {"total": result.energy.total}
        return total if name == "total" else {**own, **total}
    holder, _, vector = name.rpartition(".")
    wanted = [(holder, VECTORS[vector])] if holder and vector in VECTORS else []
    wanted += [(name, (suffix,)) for suffix in FREEDOMS if suffix not in {"rate", "speed"}]
    wanted += [(name, VECTORS[each]) for each in (*Probe.QUANTITIES, "force")]
    for whose, suffixes in wanted:
        labels = [f"{whose}.{suffix}" for suffix in suffixes]
        if all(label in result for label in labels):
            return {label: result[label] for label in labels}
    within = {column: result[column] for column in result.columns if column.startswith(f"{name}.")}
    if not within:
        known = dict.fromkeys(column.rpartition(".")[0] for column in result.columns if "." in column)
        raise KeyError(unknown("column, probe or joint", name, [*result.columns, *known, "energy"]))
    return within


def overview(result: Result) -> Grid:
    """How far probes moved since the first row, and the energies."""
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
        way = {f"{name}.{axis}": result[f"{name}.{axis}"] for axis in "xyz"}
        draw(result, {label: x - x[0] for label, x in way.items()}, None, ax, {}, f"{name} moved by")
    draw(result, columns(result, "energy"), None, axes.flat[count - 1], {})
    return axes.ravel()[:count]
