from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypedDict, final, type_check_only

import numpy as np

from ancf.record import Array

__all__ = [
    "VERSION",
    "Simulation",
    "States",
    "check_part",
    "diagnose",
    "load",
    "read",
    "report",
    "scaled",
    "schema",
    "states",
    "substitute",
    "to_toml",
]

VERSION: str

@type_check_only
class Done(TypedDict):
    columns: list[str]
    units: dict[str, str]
    rows: Array
    states: States
    summary: dict[str, Any]
    failure: str | None
    error: BaseException | None

@type_check_only
class Loaded(TypedDict):
    kind: str
    columns: list[str]
    units: dict[str, str]
    rows: Array
    frames: Array
    frame_rows: np.typing.NDArray[np.int64]
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
        callback: Callable[[list[str], Array, States], object] | None,
        tick: Callable[[float], object] | None,
        stop: Callable[[], object] | None = None,
    ) -> Done: ...
    def columns(self) -> list[str]: ...

@final
class States:
    def field(self, name: str, parts: int, frames: list[int] | None = None) -> Array: ...
    def stations(self, parts: int) -> tuple[list[str], list[int], list[float]]: ...
    def __len__(self) -> int: ...

def load(path: Path) -> Loaded: ...
def report(
    states: States,
    columns: list[str],
    rows: Array,
    values: list[float],
    summary: Mapping[str, Any],
    title: str | None,
) -> str: ...
def read(path: Path) -> dict[str, Any]: ...
def substitute(data: Mapping[str, Any], path: str, value: Any) -> tuple[dict[str, Any], list[str]]: ...
def to_toml(data: Mapping[str, Any]) -> str: ...
def scaled(data: Mapping[str, Any]) -> tuple[dict[str, Any], list[float]]: ...
def diagnose(data: Mapping[str, Any]) -> str: ...
def schema() -> str: ...
def states(model: Mapping[str, Any], text: str | None, keep: str, at: Array, numbers: Array) -> States: ...
def check_part(definition: str, data: Any) -> None: ...
