"""Sensitivity of an objective to each parameter."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ancf._ancf import linear_fit

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pandas as pd


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
    unknown = [np.nan] * len(names)
    slopes, ranks, r2 = linear_fit(x.T, y) or (unknown, unknown, np.nan)
    exponents = np.array(unknown)
    if (x > 0).all() and (y * np.sign(y[0]) > 0).all():
        log_x, log_y = np.log(x), np.log(np.abs(y))
        coefficients, _, _ = linear_fit(log_x.T, log_y) or ([0.0] * len(names), unknown, np.nan)
        exponents = np.array(coefficients) * log_y.std() / log_x.std(axis=0)
    columns = {"regression": slopes, "rank": ranks, "elasticity": exponents}
    table: pd.DataFrame = pd.DataFrame(columns, index=pd.Index(names, name="parameter"))
    table.attrs["r2"] = r2
    return table
