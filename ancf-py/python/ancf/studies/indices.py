"""Sobol's indices: the parts of the variance of an objective that parameters make."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.errors import ModelError
from ancf.studies import sampling
from ancf.studies.run import study
from ancf.studies.statement import at, fault, shown

if TYPE_CHECKING:
    from collections.abc import Mapping

    import pandas as pd

    from ancf.analysis import ModelLike
    from ancf.record import Array
    from ancf.studies.objective import Objective
    from ancf.studies.report import Study
    from ancf.studies.sampling import Distribution


def sobol(
    model: ModelLike,
    parameters: Mapping[str, Distribution],
    objective: Objective,
    *,
    samples: int,
    seed: int = 0,
    **settings: Any,
) -> pd.DataFrame:
    """Which part of the variance of each objective each parameter makes, whatever the model (Sobol 1993).

    The column `first` has the part that is due to the parameter alone, `total` that in which it has a share. Both
    are estimated from samples × (parameters + 2) cases (Saltelli et al. 2010); `settings` are those of `study`, such
    as `folder` and `client`.

    Raises
    ------
    ModelError
        With all that is wrong, before anything is run.
    ValueError
        If a case did not finish; the others are kept in the folder.

    """
    paths = sorted(parameters)
    check(parameters, samples)
    places = np.clip(sampling.sobol(2 * len(paths), samples, seed), 1e-16, 1 - 1e-16)
    quantiles = [
        [parameters[path].ppf(p) for path, p in zip(paths, half.T, strict=True)] for half in halves(places)
    ]
    first, second = (np.array(rows, dtype=float) for rows in quantiles)
    blocks = [first, second]
    for i in range(len(paths)):
        blocks.append(first.copy())
        blocks[-1][i] = second[i]
    values = dict(zip(paths, np.hstack(blocks), strict=True))
    return indices(study(model, values, objective, combine="zip", **settings), len(paths), samples)


def check(parameters: Mapping[str, Any], samples: int) -> None:
    """What is wrong with the statement, but for the model."""
    faults = [
        fault(at(path), shown(law), "a distribution, such as scipy.stats.norm(mean, deviation)")
        for path, law in parameters.items()
        if not sampling.is_distribution(law)
    ]
    if samples < 2 or samples & (samples - 1):
        faults.append(fault("samples", str(samples), "a power of 2, as Sobol's sequence has", "such as 256"))
    if faults:
        raise ModelError(faults)


def halves(points: Array) -> tuple[Array, Array]:
    """Two independent sets of points."""
    dimension = points.shape[1] // 2
    return points[:, :dimension], points[:, dimension:]


def indices(study: Study, dimension: int, samples: int) -> pd.DataFrame:
    """The indices from the cases of both sets and of the first with one parameter from the second at a time."""
    import pandas as pd
    from scipy.stats import sobol_indices

    if len(study.finished) < len(study):
        message = study.failed["message"].iloc[0]
        msg = f"{len(study.failed)} of {len(study)} cases did not finish, the first since: {message}"
        raise ValueError(msg)
    numbers = study.table[study.objectives].to_numpy(dtype=float).T.reshape(-1, dimension + 2, samples)
    blocks = {"f_A": numbers[:, 0], "f_B": numbers[:, 1], "f_AB": numbers[:, 2:].swapaxes(0, 1)}
    found = sobol_indices(func=blocks, n=samples)
    names = pd.MultiIndex.from_product([study.objectives, study.parameters], names=["objective", "parameter"])
    columns = {"first": np.ravel(found.first_order), "total": np.ravel(found.total_order)}
    table: pd.DataFrame = pd.DataFrame(columns, index=names)
    return table
