"""Motions that a program advances step by step."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ancf import _ancf
from ancf.analysis import data, stack_level
from ancf.errors import AnalysisWarning

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from numpy.typing import NDArray

    from ancf.analysis import ModelLike
    from ancf.record.columns import Array

_SIGNIFICANT = 1e-6
"""Relative correction of a given state that is reported as a warning."""


class StepInfo(NamedTuple):
    """Counts of one or several steps."""

    substeps: int
    """Accepted substeps: 1 unless the step was divided at a jump, halved, or controlled by its error."""
    iterations: int
    """Newton iterations, with those of failed attempts."""
    rejected: int
    """Attempts that error control rejected."""


class Projection(NamedTuple):
    """Correction of a given state by the projection onto the constraints."""

    moved: float
    """Largest displacement of a node or centre, length."""
    corrected: float
    """Kinetic energy of the correction of the velocities, relative to that of the given ones."""
    turned: float
    """Largest rotation of a rigid body or a section, rad."""


class BodyState:
    """State of a body: views of the arrays of a `State`, one row per nodal vector."""

    def __init__(
        self, displacements: Array, velocities: Array, reference: Array, is_position: NDArray[np.bool_]
    ) -> None:
        """Store the views."""
        self.displacements = displacements
        """Changes from the reference: of positions in lengths, of directions relative to their magnitude."""
        self.velocities = velocities
        """Rates of the displacements."""
        self.reference = reference
        """Reference positions, and unit directions."""
        self.is_position = is_position
        """True for each position, false for each direction."""

    @property
    def positions(self) -> Array:
        """Positions of the nodes or of the centre, [node, 3]. Assign new ones."""
        return (self.reference + self.displacements)[self.is_position]

    @positions.setter
    def positions(self, values: Any) -> None:
        self.displacements[self.is_position] = np.asarray(values, float) - self.reference[self.is_position]

    @property
    def directions(self) -> Array:
        """Directions: slopes and directors, relative to their reference magnitude, [direction, 3]. Assign new ones."""
        return (self.reference + self.displacements)[~self.is_position]

    @directions.setter
    def directions(self, values: Any) -> None:
        self.displacements[~self.is_position] = np.asarray(values, float) - self.reference[~self.is_position]


@dataclass
class State:
    """Complete state of a motion, in the units of the model. It is a copy: assign it to `Simulation.state`."""

    time: float
    """Time."""
    coordinates: Array
    """Coordinates: changes from the reference of all bodies, and coordinates of joints."""
    velocities: Array
    """Rates of the coordinates."""
    angles: Array
    """Angles of joints and sensors with full turns, which the coordinates determine up to these."""
    _layout: Sequence[_ancf._Layout] = field(repr=False)

    def body(self, name: str) -> BodyState:
        """Return the views of a body."""
        for own, first, is_position, reference, _ in self._layout:
            if own == name and is_position:
                part = slice(first, first + 3 * len(is_position))
                return BodyState(
                    self.coordinates[part].reshape(-1, 3),
                    self.velocities[part].reshape(-1, 3),
                    np.array(reference),
                    np.array(is_position),
                )
        msg = f"body: found {name!r}, expected one of {[own for own, _, kinds, *_ in self._layout if kinds]}"
        raise KeyError(msg)

    def joint(self, name: str) -> tuple[Array, Array]:
        """Return the views of coordinates and rates of a joint with drive, spring, friction or coupling."""
        for own, first, is_position, _, count in self._layout:
            if own == name and not is_position:
                return self.coordinates[first : first + count], self.velocities[first : first + count]
        msg = f"joint: found {name!r}, expected a joint with coordinates of its own"
        raise KeyError(msg)

    def copy(self) -> State:
        """Return a copy."""
        return State(
            self.time, self.coordinates.copy(), self.velocities.copy(), self.angles.copy(), self._layout
        )


@dataclass(frozen=True, eq=False)
class LinearModel:
    """Linear model about a state: ẋ = A x + B u, y = C x + D u, in deviations from that state.

    The minimal coordinates are x = (ξ, η), ξ = P (q - q₀), η = P (v - v₀) with the projection P = ZᵀM, Φ_q Z = 0 and
    ZᵀMZ = I. Then ξ̇ = η. States of force laws are further η, after those of the motions, without a ξ.
    The descriptor form has the coordinates q of `State`:
    M q̈ + C q̇ + K q + Gᵀ λ = F u, G q = 0.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    inputs: list[str]
    """Names of the inputs u."""
    outputs: list[str]
    """Names of the columns y."""
    input_values: Array
    """Values of the inputs in the state."""
    output_values: Array
    """Values of the columns in the state."""
    rate: Array
    """Rate ẋ in the state: zero in an equilibrium."""
    basis: Array
    """Basis Z of the free motions."""
    projection: Array
    """Projection P."""
    mass: Array
    damping: Array
    stiffness: Array
    constraints: Array
    """Jacobian matrix G of the constraints."""
    forces: Array
    """Input matrix F."""
    time: float
    coordinates: Array
    velocities: Array
    warnings: list[str]

    @property
    def poles(self) -> NDArray[np.complex128]:
        """Eigenvalues of A."""
        return np.linalg.eigvals(self.A).astype(np.complex128)

    def x(self, simulation: Simulation) -> Array:
        """Return the minimal coordinates of the present state of a simulation of the same model."""
        state = simulation.state
        q, v = state.coordinates - self.coordinates, state.velocities - self.velocities
        positions = len(self.A) - len(self.projection)
        return np.concatenate([(self.projection @ q)[:positions], self.projection @ v])


class Simulation:
    """Motion of a model that a program advances step by step. All values are in the units of the model.

    The steps are those of `ancf.run`, with the same scheme, halving of steps, error control and ends of steps at jumps.
    The duration of the analysis does not limit the motion. The stability of the states is not examined.

    Each simulation is independent. The interpreter lock is released during steps; a second call at the same time, also
    by a function of the model, raises `RuntimeError`.

    Parameters
    ----------
    model
        A model with an analysis of kind dynamics.

    Raises
    ------
    ModelError
        If the model is invalid.
    AnalysisError
        If there is no initial state.

    Warns
    -----
    AnalysisWarning
        Of the model and its initial state, as `ancf.run` does. `warnings` has those of the steps too.

    """

    def __init__(self, model: ModelLike) -> None:
        """Check and assemble the model, and compute its initial state."""
        self._stepper = _ancf.Stepper(data(model))
        for text in self.warnings:
            warnings.warn(text, AnalysisWarning, stacklevel=stack_level())

    @property
    def model(self) -> dict[str, Any]:
        """Data of the model."""
        return self._stepper.model

    @property
    def time(self) -> float:
        """Present time."""
        return self._stepper.time

    def step(self, h: float) -> StepInfo:
        """Perform one step of the size h > 0.

        It is divided where a load or drive jumps, halved if Newton's method fails, and divided as error control
        requires.

        Raises
        ------
        ValueError
            If h is not above 0.
        AnalysisError
            If the smallest substep fails, with time, cause and place. The state is that of the last accepted substep.

        """
        return StepInfo(*self._stepper.step(h))

    def advance(self, until: float) -> StepInfo:
        """Advance to a time in steps of the model; the last one ends exactly there. Raises as `step`."""
        return StepInfo(*self._stepper.advance(until))

    def set(self, name: str, value: float, *, ramp: float = 0.0) -> None:
        """Set an input from now on, at once or with a linear transition over the duration `ramp`.

        The next step starts with it. An input that prescribes a position must not jump.
        """
        self._stepper.set(name, value, ramp)

    @property
    def inputs(self) -> Mapping[str, float]:
        """Names and present values of the inputs. `set` changes them."""
        return MappingProxyType({name: self._stepper.input(name) for name in self._stepper.inputs()})

    @property
    def columns(self) -> list[str]:
        """Names of the columns, as in `Result`."""
        return self._stepper.columns()

    def read(self, name: str) -> float:
        """Return a column of the present state, such as ``"tip.y"``."""
        return self._stepper.read(name)

    def values(self, names: Iterable[str]) -> Array:
        """Return several columns of the present state."""
        names = [names] if isinstance(names, str) else names
        return np.array([self._stepper.read(name) for name in names])

    def row(self) -> dict[str, float]:
        """Return all columns of the present state."""
        return dict(zip(self.columns, self._stepper.row().tolist(), strict=True))

    def energies(self) -> dict[str, float]:
        """Return kinetic, strain and potential energy, work, dissipation and balance since the start."""
        return self._stepper.energies()

    @property
    def state(self) -> State:
        """Copy of the present state. Its velocities satisfy the constraints, without the error of the time steps.

        An assigned state is projected onto the constraints, with a warning if it moves.
        """
        time, (coordinates, velocities, angles) = self._stepper.state()
        return State(time, coordinates, velocities, angles, self._stepper.layout())

    @state.setter
    def state(self, state: State) -> None:
        moved, corrected, turned = self.set_state(state)
        size = float(np.abs(state.coordinates).max(initial=0.0))
        size = max([size, *(float(np.abs(rows).max()) for _, _, _, rows, _ in state._layout if rows)])
        if moved > _SIGNIFICANT * size or max(turned, corrected) > _SIGNIFICANT:
            text = (
                f"the state violates constraints: its correction moves a point by {moved:.3g}, turns a body or a "
                f"section by about {turned:.3g} rad and has {corrected:.3g} of the kinetic energy"
            )
            warnings.warn(text, AnalysisWarning, stacklevel=stack_level())

    def set_state(self, state: State) -> Projection:
        """Continue from a state and return its correction by the projection onto the constraints.

        Accelerations and multipliers are computed, and the energy balance begins anew. Inputs keep their values. Angles
        of hinges and sensors have the turns nearest to those of the state.
        """
        arrays = (state.coordinates, state.velocities, state.angles)
        numbers = [np.ascontiguousarray(one, float) for one in arrays]
        return Projection(*self._stepper.set_state(state.time, *numbers))

    def save(self) -> bytes:
        """Return a snapshot of everything on which later steps depend, also for another process."""
        return self._stepper.save()

    def restore(self, snapshot: bytes) -> None:
        """Continue from a snapshot of the same model; later steps are bit-identical.

        Raises
        ------
        ValueError
            If it is damaged or belongs to another model. Nothing has changed then.

        """
        self._stepper.restore(snapshot)

    def linearize(self, outputs: Iterable[str] = ()) -> LinearModel:
        """Linearise the equations of motion about the present state, for all inputs and for some columns.

        Raises
        ------
        ValueError
            If an input prescribes a motion, a column is no function of the state, or a force is not differentiable.

        """
        outputs = [outputs] if isinstance(outputs, str) else list(outputs)
        model = LinearModel(**self._stepper.linearize(outputs))
        for text in model.warnings:
            warnings.warn(text, AnalysisWarning, stacklevel=stack_level())
        return model

    @property
    def summary(self) -> Mapping[str, Any]:
        """Summary of all steps so far, with the keys of `Result.summary`."""
        summary: dict[str, Any] = self._stepper.summary()
        return summary

    @property
    def warnings(self) -> list[str]:
        """Warnings of the model and of the steps so far."""
        return list(self.summary.get("warnings", []))

    def __repr__(self) -> str:
        return f"Simulation at t = {self.time:.6g}"
