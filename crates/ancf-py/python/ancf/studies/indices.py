"""Sobol's indices: the parts of the variance of an objective that parameters make."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.errors import ModelError
from ancf.studies import sampling
from ancf.studies.run import study
from ancf.studies.statement import at, fault, is_whole, named, shown, unnamed

if TYPE_CHECKING:
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
        If a case did not finish or has no number; the others are kept in the folder.

    """
    check(parameters, objective, samples, seed, settings)
    paths, samples = sorted(parameters), int(samples)
    places = np.clip(sampling.sobol(2 * len(paths), samples, seed), 1e-16, 1 - 1e-16)
    first, second = (
        [sampling.quantiles(parameters[path], p) for path, p in zip(paths, half.T, strict=True)]
        for half in halves(places)
    )
    mixed = [[*first[:i], second[i], *first[i + 1 :]] for i in range(len(paths))]
    blocks = [first, second, *mixed]
    values = {path: [x for block in blocks for x in block[i]] for i, path in enumerate(paths)}
    return indices(study(model, values, objective, combine="zip", **settings), len(paths), samples)


def check(
    parameters: Mapping[str, Any],
    objective: object,
    samples: object,
    seed: object,
    settings: Mapping[str, Any],
) -> None:
    """What is wrong with the statement, but for the model."""
    faults = unnamed("parameters", parameters)
    if isinstance(parameters, Mapping) and not parameters:
        faults.append(fault("parameters", "none", "at least one distribution"))
    faults += [
        fault(at(path), shown(law), "a distribution, such as scipy.stats.norm(mean, deviation)")
        for path, law in named(parameters).items()
        if not sampling.is_distribution(law)
    ]
    if objective is None or (isinstance(objective, Mapping) and not objective):
        faults.append(fault("objective", "none", "at least one number whose variance is taken apart"))
    if not is_power_of_two(samples):
        faults.append(
            fault("samples", shown(samples), "a power of 2, as Sobol's sequence has", "such as 256")
        )
    if not is_whole(seed, 0):
        faults.append(fault("seed", shown(seed), "a whole number >= 0"))
    faults += [
        fault(name, shown(settings[name]), "nothing, since Sobol's sequence decides the cases")
        for name in ("combine", "sampling")
        if name in settings
    ]
    if faults:
        raise ModelError(faults)


def is_power_of_two(samples: Any) -> bool:
    """Whether this is an integer 2, 4, 8 ..."""
    return is_whole(samples, 2) and int(samples).bit_count() == 1


def halves(points: Array) -> tuple[Array, Array]:
    """Two independent sets of points."""
    dimension = points.shape[1] // 2
    return points[:, :dimension], points[:, dimension:]


def indices(study: Study, dimension: int, samples: int) -> pd.DataFrame:
    """The indices from the cases of both sets and of the first with one parameter from the second at a time."""
    import pandas as pd

    if len(study.finished) < len(study):
        message = study.failed["message"].iloc[0]
        msg = f"{len(study.failed)} of {len(study)} cases did not finish, the first since: {message}"
        raise ValueError(msg)
    for name in study.objectives:
        numberless = int((~np.isfinite(study.table[name])).sum())
        if numberless:
            msg = f"objectives.{name}: found no number in {numberless} of {len(study)} cases, wanted one in each"
            raise ValueError(msg)
    shape = (len(study.objectives), dimension + 2, samples)
    numbers = study.table[study.objectives].to_numpy(dtype=float).T.reshape(shape)
    columns = dict(zip(("first", "total"), parts(numbers), strict=True))
    names = pd.MultiIndex.from_product([study.objectives, study.parameters], names=["objective", "parameter"])
    table: pd.DataFrame = pd.DataFrame(columns, index=names)
    return table


def parts(numbers: Array) -> tuple[Array, Array]:
    """First and total indices of f, `[objective, block, sample]`, whose blocks are A, B and A with xᵢ of B.

    Sᵢ = mean(f_B (f_ABᵢ - f_A)) / V and Tᵢ = mean((f_A - f_ABᵢ)²) / (2 V), with f less its mean (Saltelli et al.
    2010, table 2, b and f); not a number if f is the same in all cases.
    """
    both = numbers[:, :2]
    centred = numbers - both.mean(axis=(1, 2), keepdims=True)
    first, second, mixed = centred[:, :1], centred[:, 1:2], centred[:, 2:]
    variance = np.where(np.ptp(both, axis=(1, 2)) > 0, both.var(axis=(1, 2)), np.nan)[:, None]
    alone = (second * (mixed - first)).mean(axis=2) / variance
    shared = 0.5 * ((first - mixed) ** 2).mean(axis=2) / variance
    return np.ravel(alone), np.ravel(shared)
