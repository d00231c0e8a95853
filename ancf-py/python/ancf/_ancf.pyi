from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypedDict, final

from ancf.record import Array

VERSION: str

class Done(TypedDict):
    columns: list[str]
    rows: Array
    states: States
    summary: dict[str, Any]
    failure: str | None
    error: BaseException | None

@final
class Simulation:
    def __new__(cls, data: Mapping[str, Any]) -> Simulation: ...
    @property
    def analysis(self) -> tuple[str, float | None]: ...
    def run(
        self,
        states: str,
        callback: Callable[[list[str], Array, States], object] | None,
        tick: Callable[[float], object] | None,
    ) -> Done: ...

@final
class States:
    def field(self, name: str, parts: int) -> Array: ...
    def stations(self, parts: int) -> tuple[list[str], list[int], list[float]]: ...
    def __len__(self) -> int: ...

def read(path: Path) -> dict[str, Any]: ...
def plain(data: Mapping[str, Any]) -> dict[str, Any]: ...
def to_toml(data: Mapping[str, Any]) -> str: ...
def scaled(data: Mapping[str, Any]) -> tuple[dict[str, Any], list[float]]: ...
def diagnose(data: Mapping[str, Any]) -> str: ...
def schema() -> str: ...
