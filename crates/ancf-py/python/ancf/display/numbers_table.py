"""Tables of columns of numbers: first, last, smallest and largest values."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from ancf.display.numbers import format_number
from ancf.display.tables import Table


def numbers_table(columns: Mapping[str, NDArray[np.float64]], units: Mapping[str, str | None]) -> Table:
    """Return the table of columns by name: extreme values over the rows, or the value of a single row."""
    has_units = any(units.get(name) not in {None, "", "1"} for name in columns)
    is_single = all(np.ndim(column) == 0 for column in columns.values())
    header = ["", *(["unit"] if has_units else []), *(["value"] if is_single else EXTREMES)]
    rows = []
    for name, column in columns.items():
        unit = units.get(name) or ""
        values = [float(column)] if np.ndim(column) == 0 else extremes(column)
        numbers = ["" if np.isnan(x) else format_number(x) for x in values]
        rows.append([name, *(["" if unit == "1" else unit] if has_units else []), *numbers])
    return Table(header, rows, names=1 + has_units)


EXTREMES = ("first", "last", "minimum", "maximum")
"""Header of a table of several rows."""


def extremes(column: NDArray[np.float64]) -> list[float]:
    """Return the first, last, smallest and largest value of a column. NaN if there is none."""
    known = column[np.isfinite(column)]
    if not known.size:
        return [np.nan] * len(EXTREMES)
    return [float(column[0]), float(column[-1]), float(known.min()), float(known.max())]
