"""Convergence: observed order and limit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ancf._ancf import observed_orders

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd


def convergence(
    rows: pd.DataFrame, parameter: str, objective: str, others: Sequence[str] = ()
) -> pd.DataFrame:
    """Estimate the order of convergence of an objective f, from the coarsest case to the finest.

    | column | meaning |
    |---|---|
    | `change` | fₖ - fₖ₋₁ |
    | `order` | p of f = f∞ + C hᵖ through this case and the two before (Roache 1994); NaN if there is none |
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
    orders, limits = observed_orders(h, f)
    known = limits[np.isfinite(limits)]
    columns = {parameter: ordered[parameter].to_numpy(), objective: f}
    columns |= {"change": np.diff(f, prepend=np.nan), "order": orders, "limit": limits}
    columns |= {"error": f - (known[-1] if len(known) else np.nan)}
    table: pd.DataFrame = pd.DataFrame(columns)
    return table
