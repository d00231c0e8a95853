"""Sobol indices: fractions of the variance of an objective due to parameters."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ancf import _ancf
from ancf.errors import ModelError
from ancf.studies.definition import sampling
from ancf.studies.definition.messages import (
    fault,
    integer_fault,
    is_integer,
    key_faults,
    parameter_path,
    shown,
    with_text_keys,
)
from ancf.studies.run import study

if TYPE_CHECKING:
    import pandas as pd

    from ancf.analysis import ModelLike
    from ancf.record.columns import Array
    from ancf.studies.definition.objective import Objective
    from ancf.studies.definition.sampling import Distribution
    from ancf.studies.report import Study


def sobol(
    model: ModelLike,
    parameters: Mapping[str, Distribution],
    objective: Objective,
    *,
    samples: int,
    seed: int = 0,
    **settings: Any,
) -> pd.DataFrame:
    """Estimate the fraction of the variance of each objective due to each parameter (Sobol 1993).

    The column `first` has the fraction due to the parameter alone, `total` the fraction due to the parameter and its
    interactions. Both are estimated from samples × (parameters + 2) cases (Saltelli et al. 2010). `settings` are
    those of `study`, such as `folder` and `client`.

    Raises
    ------
    ModelError
        If the statement is invalid, with all errors, before any case is run.
    ValueError
        If a case did not finish or has no number. The others are kept in the folder.

    """
    check(parameters, objective, samples, seed, settings)
    paths, samples = sorted(parameters), int(samples)
    points = _ancf.sobol_points(2 * len(paths), samples, int(seed))
    first, second = (
        [sampling.quantiles(parameters[path], p) for path, p in zip(paths, half, strict=True)]
        for half in np.split(points, 2)
    )
    mixed = [[*first[:i], second[i], *first[i + 1 :]] for i in range(len(paths))]
    blocks = [first, second, *mixed]
    values = {path: [x for block in blocks for x in block[i]] for i, path in enumerate(paths)}
    return indices(study(model, values, objective, combine="zip", **settings), len(paths), samples)


def check(
    parameters: Mapping[str, Any],
    objective: object,
    samples: Any,
    seed: object,
    settings: Mapping[str, Any],
) -> None:
    """Raise an error for an invalid statement. The model is not checked."""
    faults = key_faults("parameters", parameters)
    if isinstance(parameters, Mapping) and not parameters:
        faults.append(fault("parameters", "none", "at least one distribution"))
    faults += [
        fault(parameter_path(path), shown(law), "a distribution, such as scipy.stats.norm(mean, deviation)")
        for path, law in with_text_keys(parameters).items()
        if not sampling.is_distribution(law)
    ]
    if objective is None or (isinstance(objective, Mapping) and not objective):
        faults.append(fault("objective", "none", "at least one number"))
    if not is_power_of_two(samples):
        faults.append(fault("samples", shown(samples), "a power of 2, as in a Sobol sequence", "such as 256"))
    elif int(samples) > _ancf.MAX_CASES:
        faults.append(fault("samples", shown(samples), f"at most {_ancf.MAX_CASES}"))
    wrong_seed = integer_fault("seed", seed, 0, sampling.MAX_SEED)
    faults += [] if wrong_seed is None else [wrong_seed]
    if 2 * len(with_text_keys(parameters)) > _ancf.MAX_SOBOL_DIMENSION:
        expected = f"at most {_ancf.MAX_SOBOL_DIMENSION // 2} in a Sobol sequence"
        faults.append(fault("parameters", f"{len(parameters)} distributions", expected))
    faults += [
        fault(name, shown(settings[name]), "nothing, since the Sobol sequence determines the cases")
        for name in ("combine", "sampling")
        if name in settings
    ]
    if faults:
        raise ModelError(faults)


def is_power_of_two(samples: Any) -> bool:
    """Return True for an integer 2, 4, 8 ..."""
    return is_integer(samples, 2) and int(samples).bit_count() == 1


def indices(study: Study, dimension: int, samples: int) -> pd.DataFrame:
    """Estimate indices from the cases of set A, of set B, and of A with one parameter from B at a time."""
    import pandas as pd

    if len(study.finished) < len(study):
        message = study.failed["message"].iloc[0]
        msg = f"{len(study.failed)} of {len(study)} cases did not finish; the first: {message}"
        raise ValueError(msg)
    for name in study.objectives:
        numberless = int((~np.isfinite(study.table[name])).sum())
        if numberless:
            msg = f"objectives.{name}: found no number in {numberless} of {len(study)} cases, expected one in each"
            raise ValueError(msg)
    shape = (len(study.objectives), dimension + 2, samples)
    numbers = study.table[study.objectives].to_numpy(dtype=float).T.reshape(shape)
    columns = dict(zip(("first", "total"), parts(numbers), strict=True))
    names = pd.MultiIndex.from_product([study.objectives, study.parameters], names=["objective", "parameter"])
    table: pd.DataFrame = pd.DataFrame(columns, index=names)
    return table


def parts(numbers: Array) -> tuple[Array, Array]:
    """Return first and total indices of f, `[objective, block, sample]`. Blocks are A, B and A with xᵢ of B.

    Sᵢ = mean(f_B (f_ABᵢ - f_A)) / V and Tᵢ = mean((f_A - f_ABᵢ)²) / (2 V), with f less its mean (Saltelli et al.
    2010, table 2, b and f). NaN if f is constant.
    """
    both = numbers[:, :2]
    centred = numbers - both.mean(axis=(1, 2), keepdims=True)
    first, second, mixed = centred[:, :1], centred[:, 1:2], centred[:, 2:]
    variance = np.where(np.ptp(both, axis=(1, 2)) > 0, both.var(axis=(1, 2)), np.nan)[:, None]
    alone = (second * (mixed - first)).mean(axis=2) / variance
    shared = 0.5 * ((first - mixed) ** 2).mean(axis=2) / variance
    return np.ravel(alone), np.ravel(shared)
