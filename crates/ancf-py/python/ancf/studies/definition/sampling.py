"""Samples of distributions."""

from __future__ import annotations

import zlib
from typing import TYPE_CHECKING, Any, Protocol, TypeGuard

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ancf.record import Array

SAMPLINGS = ("latin_hypercube", "random", "sobol")
"""How samples fill the range of their distributions."""


class Distribution(Protocol):
    """What tells its quantiles, as the distributions of `scipy.stats` do."""

    def ppf(self, q: Any, /) -> Any:
        """The values that parts q of all values lie below, 0 < q < 1."""
        ...


def is_distribution(value: object) -> TypeGuard[Distribution]:
    """Whether a value tells its quantiles."""
    return callable(getattr(value, "ppf", None))


def parts(paths: list[str], count: int, sampling: str, seed: int) -> dict[str, Array]:
    """So many parts p of each distribution, 0 < p < 1, whose quantiles are the samples.

    Those of a parameter depend on the seed and on its path only, but for Sobol's sequence (1967), in which all
    parameters share one, scrambled (Owen 1998).
    """
    if sampling == "sobol":
        columns = dict(zip(paths, sobol(len(paths), count, seed).T, strict=True))
    else:
        columns = {path: column(path, count, sampling, seed) for path in paths}
    return {path: np.clip(p, 1e-16, 1 - 1e-16) for path, p in columns.items()}


def column(path: str, count: int, sampling: str, seed: int) -> Array:
    """Random numbers from 0 to 1, or one in each of as many equal intervals (McKay, Beckman & Conover 1979)."""
    name = zlib.crc32(path.encode())
    unit = np.random.default_rng([seed, name, 0]).random(count)
    if sampling == "random":
        return unit
    order = np.random.default_rng([seed, name, 1]).permutation(count)
    return np.asarray((order + unit) / count, dtype=float)


def sobol(dimension: int, count: int, seed: int) -> Array:
    """The first points of Sobol's sequence, `[point, dimension]`."""
    from scipy.stats import qmc

    if not dimension:
        return np.empty((count, 0))
    sequence = qmc.Sobol(dimension, scramble=True, seed=np.random.default_rng(seed))
    points: Array = sequence.random_base2(max(count - 1, 0).bit_length())
    return points[:count]


def drawn(
    distributions: Mapping[str, Distribution], count: int, sampling: str, seed: int
) -> dict[str, list[Any]]:
    """Samples of each distribution; integers of those that are discrete."""
    places = parts(sorted(distributions), count, sampling, seed)
    return {path: quantiles(distributions[path], p) for path, p in places.items()}


def quantiles(distribution: Distribution, places: Array) -> list[Any]:
    """The values that parts of all values lie below; integers of a distribution that is discrete."""
    values = np.asarray(distribution.ppf(places), dtype=float).tolist()
    return [int(x) if is_discrete(distribution) and np.isfinite(x) else x for x in values]


def is_discrete(distribution: Distribution) -> bool:
    """Whether all values of a distribution are integers."""
    return hasattr(getattr(distribution, "dist", distribution), "pmf")
