"""Cases of a study: the values of the parameters in each case."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ancf import _ancf

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence


@dataclass(frozen=True)
class ParameterAxis:
    """Values of a parameter. Case k has the value of index (k // stride) mod the number of values."""

    path: str
    values: Sequence[Any]
    stride: int

    def value(self, case: int) -> Any:
        """Return the value in a case."""
        return self.values[case // self.stride % len(self.values)]

    @cached_property
    def column_type(self) -> str:
        """Arrow type of the column of the parameter: the common type of all values, or text."""
        return _ancf.parameter_type(list(self.values))


@dataclass(frozen=True)
class Design:
    """Cases of a study.

    Every combination of lists is run with every sample of the distributions. Cases count from 0. The last parameter
    in alphabetical order varies fastest among combinations, and samples vary faster than combinations.
    """

    axes: Sequence[ParameterAxis]
    cases: int

    @classmethod
    def of(
        cls, lists: Mapping[str, Sequence[Any]], drawn: Mapping[str, Sequence[float]], combine: str
    ) -> Design:
        """Combine lists by `"grid"` or `"zip"`, and all combinations with samples."""
        samples = max(map(len, drawn.values()), default=1)
        lengths = {path: len(values) for path, values in lists.items()} | dict.fromkeys(drawn)
        found = layout(lengths, samples, combine)
        if found is None:
            raise OverflowError("there are more cases than can be counted")
        strides, cases = found
        values = {**lists, **drawn}
        return cls([ParameterAxis(path, values[path], stride) for path, stride in strides.items()], cases)

    def values(self, case: int) -> dict[str, Any]:
        """Return the values in a case, by their paths."""
        return {axis.path: axis.value(case) for axis in self.axes}


def layout(
    lengths: Mapping[str, int | None], samples: int, combine: str
) -> tuple[dict[str, int], int] | None:
    """Return strides by path and the number of cases, or None if there are too many to count.

    The length of a list is a number, that of a distribution is None.
    """
    paths = sorted(lengths)
    found = _ancf.case_layout([lengths[path] for path in paths], samples, combine)
    return None if found is None else (dict(zip(paths, found[0], strict=True)), found[1])


def plain(data: Mapping[str, Any]) -> dict[str, Any]:
    """Return the data of a model in dictionaries, lists and numbers. Functions remain functions."""
    title = data.get("title")
    copied, _ = _ancf.substitute(data, "title", title or "")
    return copied if title else {key: value for key, value in copied.items() if key != "title"}


def substituted(base: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the data of a model with values set. Raises `ModelError` if a path has no target.

    The target of a path may depend on the values of other parameters.
    """
    data = dict(base)
    for path, value in values.items():
        data, _ = _ancf.substitute(data, path, value)
    return data
