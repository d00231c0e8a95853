from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeAlias, TypedDict, final, type_check_only

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "BOX_EDGE",
    "COLOUR_MAPS",
    "MAX_CASES",
    "MAX_SOBOL_DIMENSION",
    "POINT_MASS_RADIUS",
    "STUDY_COLUMNS",
    "VERSION",
    "ModelGeometry",
    "Simulation",
    "Stage",
    "States",
    "Stepper",
    "case_layout",
    "check_part",
    "check_places",
    "diagnose",
    "inertia_box",
    "linear_fit",
    "load",
    "nearest",
    "observed_orders",
    "outline",
    "parameter_type",
    "read",
    "reduce_column",
    "report",
    "sample_probabilities",
    "scalar_fields",
    "scaled",
    "schema",
    "sobol_points",
    "stages",
    "stages_of_file",
    "states",
    "substitute",
    "to_toml",
    "zip_errors",
]

VERSION: str
BOX_EDGE: float
COLOUR_MAPS: str
POINT_MASS_RADIUS: float
STUDY_COLUMNS: list[str]
MAX_CASES: int
MAX_SOBOL_DIMENSION: int

_FaultArguments: TypeAlias = tuple[str, str, str, str | None, tuple[int, int] | None, str]

@type_check_only
class RunResults(TypedDict):
    columns: list[str]
    units: dict[str, str]
    rows: NDArray[np.float64]
    states: States
    summary: dict[str, Any]
    failure: str | None
    error: BaseException | None

@type_check_only
class LoadedResults(TypedDict):
    kind: str
    columns: list[str]
    units: dict[str, str]
    rows: NDArray[np.float64]
    frames: NDArray[np.float64]
    frame_rows: NDArray[np.int64]
    states: States
    summary: dict[str, Any]
    model: dict[str, Any]

@final
class Simulation:
    def __new__(cls, data: Mapping[str, Any]) -> Simulation: ...
    @property
    def model(self) -> dict[str, Any]: ...
    @property
    def analysis(self) -> tuple[str, float | None]: ...
    def run(
        self,
        states: str,
        callback: Callable[[list[str], NDArray[np.float64], States], object] | None,
        tick: Callable[[float], object] | None,
        stop: Callable[[], object] | None = None,
        after: tuple[States, dict[str, float]] | None = None,
    ) -> RunResults: ...
    def refine(self, requested: float) -> Simulation: ...
    def gradients(self, parameters: list[tuple[str, float | None]]) -> dict[str, Any]: ...
    def columns(self) -> list[str]: ...

_Layout: TypeAlias = tuple[str, int, list[bool], list[list[float]], int]

@final
class Stepper:
    def __new__(cls, data: Mapping[str, Any]) -> Stepper: ...
    @property
    def model(self) -> dict[str, Any]: ...
    @property
    def time(self) -> float: ...
    def step(self, h: float) -> tuple[int, int, int]: ...
    def advance(self, until: float) -> tuple[int, int, int]: ...
    def set(self, name: str, value: float, ramp: float) -> None: ...
    def input(self, name: str) -> float: ...
    def inputs(self) -> list[str]: ...
    def read(self, column: str) -> float: ...
    def row(self) -> NDArray[np.float64]: ...
    def columns(self) -> list[str]: ...
    def energies(self) -> dict[str, float]: ...
    def state(self) -> tuple[float, list[NDArray[np.float64]]]: ...
    def set_state(
        self,
        time: float,
        coordinates: NDArray[np.float64],
        velocities: NDArray[np.float64],
        angles: NDArray[np.float64],
    ) -> tuple[float, float, float]: ...
    def layout(self) -> list[_Layout]: ...
    def save(self) -> bytes: ...
    def restore(self, snapshot: bytes) -> None: ...
    def linearize(self, outputs: list[str]) -> dict[str, Any]: ...
    def summary(self) -> dict[str, Any]: ...

@final
class States:
    def field(
        self,
        name: str,
        parts: int,
        frames: list[int] | None = None,
        offset: tuple[float, float] | None = None,
    ) -> NDArray[np.float64]: ...
    def stations(self, parts: int) -> tuple[list[str], list[int], list[float]]: ...
    def __len__(self) -> int: ...
    def __repr__(self) -> str: ...

@final
class ModelGeometry:
    def __new__(cls, states: States) -> ModelGeometry: ...
    def outlines(
        self, body: str, fractions: list[float], sides: int
    ) -> tuple[NDArray[np.float64], NDArray[np.float64] | None, NDArray[np.int64]]: ...
    def surface(self, body: str) -> tuple[NDArray[np.float64], NDArray[np.int64]] | None: ...
    def arms(self, body: str) -> NDArray[np.float64]: ...
    def shape_factor(self, frame: int, size: float) -> float: ...
    def symbols(
        self, frame: int, scale: float, modal: bool
    ) -> tuple[list[str], list[str], NDArray[np.float64]]: ...
    def links(
        self, frame: int, scale: float, modal: bool
    ) -> tuple[list[str], list[str], NDArray[np.float64]]: ...

def outline(
    section: Mapping[str, Any], sides: int
) -> tuple[NDArray[np.float64], NDArray[np.float64] | None, NDArray[np.int64]]: ...
def inertia_box(
    body: Mapping[str, Any], max_edge: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
def load(path: Path) -> LoadedResults: ...
def report(
    states: States,
    columns: list[str],
    rows: NDArray[np.float64],
    values: list[float],
    summary: Mapping[str, Any],
    title: str | None,
) -> str: ...
def read(path: Path) -> dict[str, Any]: ...

@final
class Stage:
    @property
    def name(self) -> str: ...
    @property
    def folder(self) -> str: ...
    def data(self, start_time: float) -> dict[str, Any]: ...

def stages(data: Mapping[str, Any]) -> list[Stage]: ...
def stages_of_file(path: Path) -> list[Stage]: ...
def substitute(data: Mapping[str, Any], path: str, value: Any) -> tuple[dict[str, Any], list[str]]: ...
def to_toml(data: Mapping[str, Any]) -> str: ...
def scaled(data: Mapping[str, Any]) -> tuple[dict[str, Any], list[float]]: ...
def diagnose(data: Mapping[str, Any]) -> str: ...
def schema() -> str: ...
def states(
    model: Mapping[str, Any],
    text: str | None,
    keep: str,
    at: NDArray[np.float64],
    numbers: NDArray[np.float64],
) -> States: ...
def check_part(definition: str, data: Any, part: str | None = None) -> None: ...
def nearest(word: str, candidates: list[str]) -> str | None: ...
def scalar_fields(
    states: States, parts: int, frames: list[int] | None = None
) -> list[tuple[str, str, bool, NDArray[np.float64]]]: ...
def sample_probabilities(
    sampling: str, count: int, seed: int, parameters: list[str]
) -> NDArray[np.float64]: ...
def sobol_points(dimension: int, count: int, seed: int) -> NDArray[np.float64]: ...
def case_layout(lengths: list[int | None], samples: int, combine: str) -> tuple[list[int], int] | None: ...
def zip_errors(lists: list[tuple[str, int]]) -> list[_FaultArguments]: ...
def check_places(
    base: Mapping[str, Any], first_values: list[tuple[str, Any]]
) -> tuple[dict[str, Any], list[_FaultArguments]]: ...
def reduce_column(column: NDArray[np.float64], take: str) -> float: ...
def parameter_type(values: list[Any]) -> str: ...
def observed_orders(
    sizes: NDArray[np.float64], values: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]: ...
def linear_fit(
    columns: NDArray[np.float64], values: NDArray[np.float64]
) -> tuple[list[float], list[float], float] | None: ...
