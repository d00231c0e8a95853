"""Derivatives of results with respect to numbers of a model."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ancf import _ancf
from ancf.analysis import data, stack_level
from ancf.errors import AnalysisError, AnalysisWarning

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ancf.analysis import ModelLike
    from ancf.record.columns import Array


@dataclass(frozen=True, eq=False)
class Gradients:
    """Derivatives of results with respect to numbers of a model, in its units.

    `found["tip.z", "materials.steel.young"]` is one derivative.
    """

    quantities: list[str]
    """Names of the results: columns of statics, ``frequency[0]`` ... of modes, ``factor[0]`` ... of buckling."""
    values: Array
    """Values of the results."""
    parameters: list[str]
    """Paths of the parameters."""
    parameter_values: Array
    """Values of the parameters."""
    derivatives: Array
    """Derivatives, one row for each result and one column for each parameter."""
    errors: Array
    """Estimated numerical errors of the derivatives, without that of the mesh."""
    warnings: list[str]

    @property
    def relative(self) -> Array:
        """Relative derivatives d ln y/d ln p; not finite for a result of zero."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return self.derivatives * self.parameter_values / self.values[:, np.newaxis]

    def __getitem__(self, of: tuple[str, str]) -> float:
        """Return the derivative of a result with respect to a parameter.

        Raises
        ------
        KeyError
            If there is no such result or parameter.

        """
        quantity, parameter = of
        row = _number(self.quantities, quantity, "result")
        return float(self.derivatives[row, _number(self.parameters, parameter, "parameter")])


def _number(names: list[str], name: str, what: str) -> int:
    if name in names:
        return names.index(name)
    near = _ancf.nearest(name, names)
    meant = "" if near is None else f" (did you mean {near!r}?)"
    msg = f"no {what} {name!r}{meant}"
    raise KeyError(msg)


def gradients(model: ModelLike, parameters: str | Iterable[str] | Mapping[str, float | None]) -> Gradients:
    """Differentiate the results of statics, modes or buckling with respect to numbers of the model.

    The equations of the solution are differentiated and solved once for each parameter; no analysis is repeated. The
    derivatives are those of the discrete model, to about ten digits.

    Parameters
    ----------
    model
        An `ancf.Model`, its data in dictionaries, or the path of a model file.
    parameters
        Paths of numbers, such as ``materials.steel.young`` or ``loads[0].force[2]``, as in studies. A mapping has the
        size of the largest change of each number for differences; by default an eighth of it. A number that is zero
        needs a size, unless it is the component of a vector with others.

    Raises
    ------
    ModelError
        If the model or a parameter is invalid, or the analysis has no gradients.
    AnalysisError
        If the analysis fails, or the results have no derivative: a force has a kink.

    Warns
    -----
    AnalysisWarning
        For each of the `warnings`, such as equal frequencies or inaccurate derivatives.

    """
    sizes: list[tuple[str, float | None]]
    if isinstance(parameters, Mapping):
        sizes = list(parameters.items())
    else:
        sizes = [(path, None) for path in ([parameters] if isinstance(parameters, str) else parameters)]
    simulation = _ancf.Simulation(data(model))
    try:
        found = Gradients(**simulation.gradients(sizes))
    except RuntimeError as error:
        raise AnalysisError(str(error)) from None
    for text in found.warnings:
        warnings.warn(text, AnalysisWarning, stacklevel=stack_level())
    return found
