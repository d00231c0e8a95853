"""Statement of a study and its errors."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from ancf import _ancf
from ancf.errors import Fault, ModelError
from ancf.model.base.part import plain as plain_value
from ancf.model.base.tables import Tables
from ancf.studies.definition.design import Design, layout
from ancf.studies.definition.messages import (
    choice_fault,
    fault,
    integer_fault,
    is_integer,
    join,
    key_faults,
    listed,
    near,
    parameter_path,
    quoted,
    shown,
    with_text_keys,
)
from ancf.studies.definition.objective import TAKES, Objectives, pair
from ancf.studies.definition.sampling import MAX_SEED, SAMPLINGS, Distribution, is_distribution, samples


@dataclass
class Statement:
    """Statement of a study. `faults` are its errors."""

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
    """Data of the model with the first value of every parameter, or the median of its distribution."""

    def design(self, parameters: Mapping[str, Any]) -> Design:
        """Return the cases. Raises `ModelError` with all errors, before any case is run."""
        self._settings()
        self.faults += key_faults("parameters", parameters)
        for path in sorted(with_text_keys(parameters)):
            self._parameter(path, parameters[path])
        self._count()
        self._zip()
        self._paths()
        self._names()
        drawn = {} if self.faults else self._samples()
        self._columns()
        if self.faults:
            raise ModelError(self.faults)
        return Design.of(self.lists, drawn, self.combine)

    def _fault(self, path: str, found: str, expected: str, hint: str | None = None) -> None:
        self.faults.append(fault(path, found, expected, hint))

    def _settings(self) -> None:
        """Check the settings of the samples."""
        found = [
            choice_fault("combine", self.combine, ("grid", "zip")),
            choice_fault("sampling", self.sampling, SAMPLINGS),
            integer_fault("seed", self.seed, 0, MAX_SEED),
        ]
        self.faults += [one for one in found if one is not None]

    def _parameter(self, path: str, values: Any) -> None:
        """Sort a parameter into lists and distributions."""
        if is_distribution(values):
            self.distributions[path] = values
            return
        if not isinstance(values, Iterable) or isinstance(values, str | Mapping):
            expected = "a list of values, or a distribution such as scipy.stats.norm(mean, deviation)"
            self._fault(parameter_path(path), shown(values), expected)
            return
        given = [plain_value(value, Tables()) for value in values]
        if given:
            self.lists[path] = given
        else:
            self._fault(parameter_path(path), "an empty list", "a list of at least one value")

    def _count(self) -> None:
        """Check the numbers of samples and cases."""
        if self.samples is not None:
            wrong = integer_fault("samples", self.samples, 1, _ancf.MAX_CASES)
            if wrong is not None:
                self.faults.append(wrong)
                return
        if self.distributions and self.samples is None:
            first = next(iter(self.distributions))
            expected = "the number of samples, such as `samples=100`"
            self._fault(parameter_path(first), "a distribution without `samples`", expected)
        if self.sampling == "sobol" and len(self.distributions) > _ancf.MAX_SOBOL_DIMENSION:
            expected = f"at most {_ancf.MAX_SOBOL_DIMENSION} in a Sobol sequence"
            self._fault("parameters", f"{len(self.distributions)} distributions", expected)
        if self._cases() > _ancf.MAX_CASES:
            self._fault("parameters", "too many combinations", "at most 10 000 000 cases")

    def _cases(self) -> float:
        """Return the number of cases."""
        per_combination = int(self.samples or 1) if self.distributions else 1
        lengths = {path: len(values) for path, values in self.lists.items()}
        found = layout(lengths, per_combination, "zip" if self.combine == "zip" else "grid")
        return math.inf if found is None else found[1]

    def _zip(self) -> None:
        """Check that zipped lists have the same length."""
        if self.combine == "zip":
            lengths = [(path, len(values)) for path, values in self.lists.items()]
            self.faults += [Fault(*arguments) for arguments in _ancf.zip_errors(lengths)]

    def _paths(self) -> None:
        """Find paths without a target and conflicts between parameters."""
        first = {path: values[0] for path, values in self.lists.items()}
        first |= {path: float(law.ppf(0.5)) for path, law in self.distributions.items()}
        self.first, errors = _ancf.check_places(self.base, sorted(first.items()))
        self.faults += [Fault(*arguments) for arguments in errors]

    def _names(self) -> None:
        """Find columns of the table with the same name."""
        self.faults += key_faults("objectives", self.objectives.readings)
        for path in sorted({*self.lists, *self.distributions} & set(_ancf.STUDY_COLUMNS)):
            self._fault(
                parameter_path(path), f"`{path}`, which is another column of the table", "another path"
            )
        for name in with_text_keys(self.objectives.readings):
            if name in _ancf.STUDY_COLUMNS or name in self.lists or name in self.distributions:
                self._fault(
                    join("objectives", name),
                    f"`{name}`, which is another column of the table",
                    "another name",
                )

    def _samples(self) -> dict[str, list[Any]]:
        """Draw samples of all distributions. Their quantiles must be finite."""
        drawn = samples(self.distributions, int(self.samples or 1), self.sampling, int(self.seed))
        for path, values in drawn.items():
            wrong = next((x for x in values if not math.isfinite(x)), None)
            if wrong is not None:
                self._fault(
                    parameter_path(path), f"a distribution with the quantile {wrong}", "finite quantiles"
                )
        return drawn

    def _columns(self) -> None:
        """Find invalid readings and columns that the results do not have."""
        known: list[str] | None = None
        for name, reading in with_text_keys(self.objectives.readings).items():
            path = join("objectives", name)
            if callable(reading):
                continue
            if not is_reading(reading):
                expected = (
                    'a function of the result, or a column and what is taken of it, such as ("tip.y", "mean")'
                )
                self._fault(path, shown(reading), expected)
                continue
            column, take = pair(reading)
            if isinstance(take, str) and take not in TAKES:
                self._fault(path, quoted(take), listed([*TAKES, "a row from 0"]), near(take, TAKES))
            known = result_columns(self.first) if known is None else known
            if known and column not in known:
                found = f"{quoted(column)}, which is no column of the results"
                self._fault(path, found, "a column of the results of the model", near(column, known))


def is_reading(reading: Any) -> bool:
    """Return True for a column, or a pair of a column and a reduction or a row."""
    if isinstance(reading, str):
        return True
    is_pair = isinstance(reading, tuple | list) and len(reading) == 2 and isinstance(reading[0], str)
    if not is_pair or isinstance(reading[1], bool):
        return False
    return isinstance(reading[1], str) or is_integer(reading[1], 0)


def result_columns(base: Mapping[str, Any]) -> list[str]:
    """Return the columns of a run. An invalid model has none."""
    try:
        return _ancf.Simulation(base).columns()
    except ModelError:
        return []
