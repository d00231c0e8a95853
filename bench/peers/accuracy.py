"""Errors of runs, and times at equal errors."""

import math

import numpy as np


def distance(a: np.ndarray, b: np.ndarray) -> float:
    """Root mean square distance of two paths."""
    return float(np.sqrt(np.mean(np.sum((a - b) ** 2, axis=1))))


def front(found: list[dict]) -> list[tuple[float, float]]:
    """The runs (error, time) that no other beats in both, by falling error."""
    best: list[tuple[float, float]] = []
    for error, seconds in sorted((point["error"], point["seconds"]) for point in found):
        if not best or seconds < best[-1][1]:
            best.append((error, seconds))
    return best[::-1]


def time_at(target: float, best: list[tuple[float, float]]) -> float:
    """Time at an error, linear in the logarithms between runs of a front; else not a number."""
    if not best or target < best[-1][0]:
        return math.nan
    if target >= best[0][0]:
        return best[0][1]
    logs = np.log(np.array(best[::-1]))
    return float(np.exp(np.interp(math.log(target), logs[:, 0], logs[:, 1])))
