"""Convergence: observed order and limit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd

MAX_ORDER = 20.0
"""Upper bound of the observed order."""


def convergence(
    rows: pd.DataFrame, parameter: str, objective: str, others: Sequence[str] = ()
) -> pd.DataFrame:
    """Estimate the order of convergence of an objective f, from the coarsest case to the finest.

    | column | meaning |
    |---|---|
    | `change` | fₖ - fₖ₋₁ |
    | `order` | p of f = f∞ + C hᵖ through this case and the two before; NaN if there is none |
    | `limit` | f∞ (Richardson 1911) from the order and the last two cases |
    | `error` | f - f∞ with the limit of the finest case with an order |

    Integers are counts with h = 1/count. Other numbers are sizes h, such as a time step.

    Raises
    ------
    ValueError
        If another parameter varies, or the parameter is not a number.

    """
    import pandas as pd

    varying = [other for other in others if rows[other].nunique() > 1]
    if varying:
        msg = f"{varying[0]!r} varies too: select one of its values, such as where={{{varying[0]!r}: ...}}"
        raise ValueError(msg)
    if not pd.api.types.is_numeric_dtype(rows[parameter]):
        msg = f"{parameter!r} has no numbers"
        raise ValueError(msg)
    is_count = pd.api.types.is_integer_dtype(rows[parameter])
    ordered = rows.drop_duplicates(parameter).sort_values(parameter, ascending=is_count)
    sizes = ordered[parameter].to_numpy(dtype=float)
    h, f = 1 / sizes if is_count else sizes, ordered[objective].to_numpy(dtype=float)
    orders, limits = np.full(len(f), np.nan), np.full(len(f), np.nan)
    for k in range(2, len(f)):
        orders[k] = order(h[k - 2 : k + 1], f[k - 2 : k + 1])
        limits[k] = f[k] + (f[k] - f[k - 1]) / ((h[k - 1] / h[k]) ** orders[k] - 1)
    known = limits[np.isfinite(limits)]
    columns = {parameter: ordered[parameter].to_numpy(), objective: f}
    columns |= {"change": np.diff(f, prepend=np.nan), "order": orders, "limit": limits}
    columns |= {"error": f - (known[-1] if len(known) else np.nan)}
    table: pd.DataFrame = pd.DataFrame(columns)
    return table


def order(
    h: np.ndarray[tuple[int], np.dtype[np.float64]], f: np.ndarray[tuple[int], np.dtype[np.float64]]
) -> float:
    """Return the order p with (f₂ - f₁)/(f₃ - f₂) = (h₁ᵖ - h₂ᵖ)/(h₂ᵖ - h₃ᵖ), h₁ > h₂ > h₃ (Roache 1994)."""
    from scipy.optimize import brentq

    first, second = f[1] - f[0], f[2] - f[1]
    a, b = np.log(h[0] / h[1]), np.log(h[1] / h[2])
    # The right side increases with p, from a/b at p = 0.
    if second == 0 or not first / second > a / b:
        return float("nan")
    ratio = first / second

    def excess(p: float) -> float:
        return float(np.exp(b * p) * np.expm1(a * p) / np.expm1(b * p) - ratio)

    if excess(MAX_ORDER) < 0:
        return float("nan")
    return float(brentq(excess, 1e-9, MAX_ORDER))
