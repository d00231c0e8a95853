"""Sensitivity of an objective to each parameter."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd

    from ancf.record.columns import Array


def sensitivity(rows: pd.DataFrame, parameters: Sequence[str], objective: str) -> pd.DataFrame:
    """Estimate the sensitivity of an objective y to each varying numeric parameter x.

    `regression`
        Standardised coefficient of the linear regression on all parameters. Its square is the fraction of the
        variance of y due to x, if y is linear and parameters are independent.
    `rank`
        Rank correlation of Spearman (1904): 1 or -1 if y is a monotonic function of x alone.
    `elasticity`
        n of y ~ xⁿ, by regression of the logarithms. NaN unless all x are positive and all y have the same sign.

    The attribute `r2` of the table is the fraction of the variance of y that the linear regression explains.

    Raises
    ------
    ValueError
        If no numeric parameter varies, or there are fewer cases than coefficients.

    """
    import pandas as pd
    from scipy.stats import rankdata

    rows = rows[np.isfinite(rows[objective])]
    kinds = pd.api.types
    names = [
        name
        for name in parameters
        if kinds.is_numeric_dtype(rows[name])
        and not kinds.is_bool_dtype(rows[name])
        and rows[name].nunique() > 1
    ]
    if not names or len(rows) < len(names) + 2:
        msg = f"{len(rows)} cases with {len(names)} varying numeric parameters determine no sensitivity"
        raise ValueError(msg)
    x, y = rows[names].to_numpy(dtype=float), rows[objective].to_numpy(dtype=float)
    slopes, r2 = regression(x, y)
    ranks = [
        float(np.corrcoef(rankdata(column), rankdata(y))[0, 1]) if np.ptp(y) else np.nan for column in x.T
    ]
    positive = (x > 0).all(axis=0)
    exponents = np.full(len(names), np.nan)
    if positive.all() and (y * np.sign(y[0]) > 0).all():
        exponents, _ = regression(np.log(x), np.log(np.abs(y)))
    scale = x.std(axis=0) / y.std() if np.ptp(y) else np.nan
    columns = {"regression": slopes * scale, "rank": ranks, "elasticity": exponents}
    table: pd.DataFrame = pd.DataFrame(columns, index=pd.Index(names, name="parameter"))
    table.attrs["r2"] = r2
    return table


def regression(x: Array, y: Array) -> tuple[Array, float]:
    """Return the slopes of the linear regression of y on x, and the explained fraction of the variance."""
    deviations, offsets = x - x.mean(axis=0), y - y.mean()
    widths = deviations.std(axis=0)
    slopes, *_ = np.linalg.lstsq(deviations / widths, offsets, rcond=None)
    rest = offsets - deviations / widths @ slopes
    return slopes / widths, float(1 - (rest @ rest) / (offsets @ offsets)) if np.ptp(y) else np.nan
