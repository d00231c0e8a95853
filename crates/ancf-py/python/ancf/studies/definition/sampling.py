"""Samples of distributions."""

from __future__ import annotations

import zlib
from typing import TYPE_CHECKING, Any, Protocol, TypeGuard

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ancf.record.columns import Array

SAMPLINGS = ("latin_hypercube", "random", "sobol")
"""Sampling methods."""


class Distribution(Protocol):
    """A distribution with a quantile function, such as those of `scipy.stats`."""

    def ppf(self, q: Any, /) -> Any:
        """Return the quantiles of probabilities 0 < q < 1."""
        ...


def is_distribution(value: object) -> TypeGuard[Distribution]:
    """Return True if a value has a quantile function."""
    return callable(getattr(value, "ppf", None))


def probabilities(paths: list[str], count: int, sampling: str, seed: int) -> dict[str, Array]:
    """Return `count` probabilities, 0 < p < 1, for each path. Their quantiles are the samples.

    Those of a parameter depend on the seed and on its path only. In Sobol's sequence (1967), scrambled (Owen 1998),
    they also depend on the other paths.
    """
    if sampling == "sobol":
        columns = dict(zip(paths, sobol_points(len(paths), count, seed).T, strict=True))
    else:
        columns = {path: column(path, count, sampling, seed) for path in paths}
    return {path: np.clip(p, 1e-16, 1 - 1e-16) for path, p in columns.items()}


def column(path: str, count: int, sampling: str, seed: int) -> Array:
    """Return independent samples of (0, 1), or a Latin hypercube (McKay, Beckman & Conover 1979)."""
    name = zlib.crc32(path.encode())
    unit = np.random.default_rng([seed, name, 0]).random(count)
    if sampling == "random":
        return unit
    order = np.random.default_rng([seed, name, 1]).permutation(count)
    return np.asarray((order + unit) / count, dtype=float)


def sobol_points(dimension: int, count: int, seed: int) -> Array:
    """Return the first points of a scrambled Sobol sequence, `[point, dimension]`."""
    from scipy.stats import qmc

    if not dimension:
        return np.empty((count, 0))
    sequence = qmc.Sobol(dimension, scramble=True, seed=np.random.default_rng(seed))
    points: Array = sequence.random_base2(max(count - 1, 0).bit_length())
    return points[:count]


def samples(
    distributions: Mapping[str, Distribution], count: int, sampling: str, seed: int
) -> dict[str, list[Any]]:
    """Return samples of each distribution, integers for discrete distributions."""
    found = probabilities(sorted(distributions), count, sampling, seed)
    return {path: quantiles(distributions[path], p) for path, p in found.items()}


def quantiles(distribution: Distribution, p: Array) -> list[Any]:
    """Return the quantiles of probabilities, integers for discrete distributions."""
    values = np.asarray(distribution.ppf(p), dtype=float).tolist()
    return [int(x) if is_discrete(distribution) and np.isfinite(x) else x for x in values]


def is_discrete(distribution: Distribution) -> bool:
    """Return True if all values of a distribution are integers."""
    return hasattr(getattr(distribution, "dist", distribution), "pmf")
