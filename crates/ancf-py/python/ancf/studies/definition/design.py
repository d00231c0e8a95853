"""The cases of a study: which values the parameters have in each."""

from __future__ import annotations

from dataclasses import dataclass
from math import prod
from typing import TYPE_CHECKING, Any

from ancf import _ancf

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence


@dataclass(frozen=True)
class Axis:
    """The values of a parameter; in case k it is that at (k // stride) mod their number."""

    path: str
    values: Sequence[Any]
    stride: int

    def value(self, case: int) -> Any:
        """The value in a case."""
        return self.values[case // self.stride % len(self.values)]


@dataclass(frozen=True)
class Design:
    """The cases of a study.

    Every combination of lists is run with every sample of the distributions. Cases count from 0; of combinations
    the last parameter runs fastest, in alphabetical order, and samples run faster still.
    """

    axes: Sequence[Axis]
    cases: int

    @classmethod
    def of(
        cls, lists: Mapping[str, Sequence[Any]], drawn: Mapping[str, Sequence[float]], combine: str
    ) -> Design:
        """The cases of lists that are combined by `"grid"` or `"zip"`, and of samples."""
        samples = max(map(len, drawn.values()), default=1)
        cases, axes = samples, [Axis(path, values, 1) for path, values in drawn.items()]
        for path in sorted(lists, reverse=True):
            stride = cases if combine == "grid" else samples
            cases = stride * len(lists[path])
            axes.append(Axis(path, lists[path], stride))
        return cls(sorted(axes, key=lambda axis: axis.path), cases)

    def values(self, case: int) -> dict[str, Any]:
        """The values in a case, by their paths."""
        return {axis.path: axis.value(case) for axis in self.axes}


def count(lengths: Sequence[int], samples: int, combine: str) -> int:
    """How many cases lists of such lengths make with so many samples."""
    return samples * (prod(lengths) if combine == "grid" else max(lengths, default=1))


def plain(data: Mapping[str, Any]) -> dict[str, Any]:
    """The data of a model in dictionaries, lists and numbers; functions stay functions."""
    title = data.get("title")
    copied, _ = _ancf.substitute(data, "title", title or "")
    return copied if title else {key: value for key, value in copied.items() if key != "title"}


def substituted(base: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """The data of a model with values set; raises `ModelError` if a path leads nowhere.

    So it may once another parameter has been set.
    """
    data = dict(base)
    for path, value in values.items():
        data, _ = _ancf.substitute(data, path, value)
    return data
