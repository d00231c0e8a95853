"""What a study states, and all that can be wrong with it."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ancf import _ancf
from ancf.errors import Fault, ModelError
from ancf.part import plain as plain_value
from ancf.studies.design import Design, count
from ancf.studies.objective import TAKES, Objectives, pair
from ancf.studies.places import clashes
from ancf.studies.sampling import SAMPLINGS, Distribution, drawn, is_distribution
from ancf.studies.table import COLUMNS
from ancf.tables import Tables

MANY = 10_000_000
"""The most cases of a study."""


@dataclass
class Statement:
    """A study as it is stated; `faults` are what is wrong with it."""

    base: dict[str, Any]
    objectives: Objectives
    samples: int | None
    seed: int
    combine: str
    sampling: str
    lists: dict[str, list[Any]] = field(default_factory=dict)
    distributions: dict[str, Distribution] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)
    first: dict[str, Any] = field(default_factory=dict)
    """The model with the first value of every parameter, the median of distributions."""

    def design(self, parameters: Mapping[str, Any]) -> Design:
        """The cases; raises `ModelError` with all that is wrong, before anything is run."""
        self._choose("combine", self.combine, ("grid", "zip"))
        self._choose("sampling", self.sampling, SAMPLINGS)
        self.faults += unnamed("parameters", parameters)
        for path in sorted(named(parameters)):
            self._parameter(path, parameters[path])
        self._count()
        self._zip()
        self._paths()
        self._names()
        samples = {} if self.faults else self._drawn()
        self._columns()
        if self.faults:
            raise ModelError(self.faults)
        return Design.of(self.lists, samples, self.combine)

    def _fault(self, path: str, found: str, wanted: str, hint: str | None = None) -> None:
        self.faults.append(fault(path, found, wanted, hint))

    def _choose(self, name: str, word: object, words: Iterable[str]) -> None:
        found = choice(name, word, words)
        if found is not None:
            self.faults.append(found)

    def _parameter(self, path: str, values: Any) -> None:
        if is_distribution(values):
            self.distributions[path] = values
            return
        if not isinstance(values, Iterable) or isinstance(values, str | Mapping):
            wanted = "a list of values, or a distribution such as scipy.stats.norm(mean, deviation)"
            self._fault(at(path), shown(values), wanted)
            return
        given = [plain_value(value, Tables()) for value in values]
        if given:
            self.lists[path] = given
        else:
            self._fault(at(path), "an empty list", "a list of at least one value")

    def _count(self) -> None:
        """How many samples and cases there are."""
        if self.samples is not None and not is_whole(self.samples, 1):
            self._fault("samples", shown(self.samples), "a whole number >= 1")
            return
        if self.distributions and self.samples is None:
            first = next(iter(self.distributions))
            wanted = "the number of samples, such as `samples=100`"
            self._fault(at(first), "a distribution without `samples`", wanted)
        if not is_whole(self.seed, 0):
            self._fault("seed", shown(self.seed), "a whole number >= 0")
        samples = (self.samples or 1) if self.distributions else 1
        if count([len(values) for values in self.lists.values()], samples, self.combine) > MANY:
            self._fault("parameters", "too many combinations", "at most 10 000 000 cases")

    def _zip(self) -> None:
        if self.combine != "zip" or not self.lists:
            return
        first, *others = self.lists
        length = len(self.lists[first])
        for path in others:
            if len(self.lists[path]) != length:
                wanted = f'{length}, as many as `{first}` has, since `combine` is "zip"'
                self._fault(at(path), f"{len(self.lists[path])} values", wanted)

    def _paths(self) -> None:
        """Paths that the model has not, and parameters that are in each other's way."""
        self.first, places = dict(self.base), {}
        for path in sorted([*self.lists, *self.distributions]):
            value = self.lists[path][0] if path in self.lists else float(self.distributions[path].ppf(0.5))
            try:
                self.first, places[path] = _ancf.substitute(self.first, path, value)
            except ModelError as error:
                for one in error.errors:
                    self._fault(at(path), one.found, one.wanted, one.hint)
        for path, found, wanted, hint in clashes(self.first, places):
            self._fault(at(path), found, wanted, hint)

    def _names(self) -> None:
        """Columns of the table that would have the same name."""
        self.faults += unnamed("objectives", self.objectives.readings)
        for path in sorted({*self.lists, *self.distributions} & set(COLUMNS)):
            self._fault(at(path), f"`{path}`, which is another column of the table", "another path")
        for name in named(self.objectives.readings):
            if name in COLUMNS or name in self.lists or name in self.distributions:
                self._fault(
                    join("objectives", name),
                    f"`{name}`, which is another column of the table",
                    "another name",
                )

    def _drawn(self) -> dict[str, list[Any]]:
        samples = drawn(self.distributions, self.samples or 1, self.sampling, self.seed)
        for path, values in samples.items():
            wrong = next((x for x in values if not math.isfinite(x)), None)
            if wrong is not None:
                self._fault(at(path), f"a distribution with the quantile {wrong}", "finite quantiles")
        return samples

    def _columns(self) -> None:
        """Readings that are none, and columns that the results have not."""
        known: list[str] | None = None
        for name, reading in named(self.objectives.readings).items():
            path = join("objectives", name)
            if callable(reading):
                continue
            if not is_reading(reading):
                wanted = (
                    'a function of the result, or a column and what is taken of it, such as ("tip.y", "mean")'
                )
                self._fault(path, shown(reading), wanted)
                continue
            column, take = pair(reading)
            if isinstance(take, str) and take not in TAKES:
                self._fault(path, quoted(take), listed([*TAKES, "a row from 0"]), near(take, TAKES))
            known = columns(self.first) if known is None else known
            if known and column not in known:
                found = f"{quoted(column)}, which is no column of the results"
                self._fault(path, found, "a column of the results of the model", near(column, known))


def fault(path: str, found: str, wanted: str, hint: str | None = None) -> Fault:
    """One thing that is wrong, in the words of the engine."""
    text = f"{path}: found {found}, wanted {wanted}" + (f" ({hint})" if hint else "")
    return Fault(path, found, wanted, hint, None, text)


def choice(name: str, word: object, words: Iterable[str]) -> Fault | None:
    """What is wrong if a word is none of those there are."""
    if isinstance(word, str) and word in words:
        return None
    return fault(name, shown(word), listed(words), near(word, words) if isinstance(word, str) else None)


def is_whole(value: object, least: int) -> bool:
    """Whether a value is an integer, of Python or NumPy, that is not too small."""
    return isinstance(value, int | np.integer) and not isinstance(value, bool) and int(value) >= least


def named(data: object) -> Mapping[str, Any]:
    """What has a name that is a text."""
    return (
        {key: value for key, value in data.items() if isinstance(key, str)}
        if isinstance(data, Mapping)
        else {}
    )


def unnamed(path: str, data: object) -> list[Fault]:
    """What is wrong with data that should have names."""
    if not isinstance(data, Mapping):
        return [fault(path, shown(data), "a dictionary")]
    return [
        fault(path, f"the name {shown(key)}", "texts as names") for key in data if not isinstance(key, str)
    ]


def is_reading(reading: Any) -> bool:
    """Whether this is a column, or a column and what is taken of it."""
    if isinstance(reading, str):
        return True
    is_pair = isinstance(reading, tuple | list) and len(reading) == 2 and isinstance(reading[0], str)
    if not is_pair or isinstance(reading[1], bool):
        return False
    return isinstance(reading[1], str) or is_whole(reading[1], 0)


def columns(base: Mapping[str, Any]) -> list[str]:
    """The columns of a run; none of what is no valid model."""
    try:
        return _ancf.Simulation(base).columns()
    except ModelError:
        return []


def at(path: str) -> str:
    """The place of a parameter in the statement."""
    return join("parameters", path)


def join(path: str, name: str) -> str:
    """A path with a name, in quotes if it has other signs than letters, digits, `_` and `-`."""
    bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return f"{path}.{name}" if bare else f"{path}.{json.dumps(name, ensure_ascii=False)}"


def quoted(word: object) -> str:
    """A word in quotes."""
    return f'"{word}"'


def listed(words: Iterable[str]) -> str:
    """Words in quotes, with commas."""
    *first, last = [word if " " in word else quoted(word) for word in words]
    return f"{', '.join(first)} or {last}" if first else last


def near(word: str, words: Iterable[str]) -> str | None:
    """The word that was probably meant."""
    from difflib import get_close_matches

    found = get_close_matches(word, list(words), n=1)
    return f"did you mean {quoted(found[0])}?" if found else None


def shown(value: Any) -> str:
    """A value as it is written, if it is short, or what it is."""
    told = quoted(value) if isinstance(value, str) else repr(value)
    return told if len(told) <= 40 else f"a {type(value).__name__}"
