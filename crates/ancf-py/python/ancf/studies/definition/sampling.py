"""Samples of distributions, with the probabilities of the study engine."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol, TypeGuard

import numpy as np

from ancf import _ancf

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ancf.record.columns import Array

SAMPLINGS = ("latin_hypercube", "random", "sobol")
"""Sampling methods."""

MAX_SEED = 2**32 - 1
"""Maximum seed."""


class Distribution(Protocol):
    """A distribution with a quantile function, such as those of `scipy.stats`."""

    def ppf(self, q: Any, /) -> Any:
        """Return the quantiles of probabilities 0 < q < 1."""
        ...


def is_distribution(value: object) -> TypeGuard[Distribution]:
    """Return True if a value has a quantile function."""
    return callable(getattr(value, "ppf", None))


def samples(
    distributions: Mapping[str, Distribution], count: int, sampling: str, seed: int
) -> dict[str, list[Any]]:
    """Return samples of each distribution, integers for discrete distributions.

    The samples of a parameter depend on the seed and on its path. Those of a scrambled Sobol sequence depend on the
    seed and on the position of the path. The program `ancf study` draws the same samples.
    """
    paths = sorted(distributions)
    probabilities = _ancf.sample_probabilities(sampling, count, seed, paths)
    return {path: quantiles(distributions[path], p) for path, p in zip(paths, probabilities, strict=True)}


def quantiles(distribution: Distribution, p: Array) -> list[Any]:
    """Return the quantiles of probabilities, integers for discrete distributions."""
    values = np.asarray(distribution.ppf(p), dtype=float).tolist()
    return [int(x) if is_discrete(distribution) and np.isfinite(x) else x for x in values]


def is_discrete(distribution: Distribution) -> bool:
    """Return True if all values of a distribution are integers."""
    return hasattr(getattr(distribution, "dist", distribution), "pmf")
