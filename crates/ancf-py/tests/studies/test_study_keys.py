"""Studies: keys of cases, which prevent the reuse of stale results."""

from __future__ import annotations

import functools
import subprocess
import sys
import threading
import types
from typing import Any

import pytest

from ancf.studies.definition.fingerprint import describe

PROGRAM = """
import functools, math
from collections import deque, OrderedDict
from dataclasses import dataclass, field
from enum import Enum
from functools import lru_cache, partial
from typing import NamedTuple
import numpy as np
from numpy import mean

class Kind(Enum):
    TIP = 1

@dataclass
class Limits:
    low: float = 0.0
    more: list = field(default_factory=list)
    def clip(self, x):
        return max(self.low, x)

class Pair(NamedTuple):
    a: float
    b: float = 2.0

def scaled(factor, x):
    return factor * x

@lru_cache
def cached(x):
    return x + 1

LIMITS, SET, RAW, NOTHING, QUEUE = Limits(1.0), {"a", "b", "c"}, b"raw", None, deque([1, 2])
twice = partial(scaled, 2.0)

def objective(result):
    pair = Pair(LIMITS.low), Kind.TIP, SET, RAW, NOTHING, QUEUE, np, math, mean, OrderedDict
    return cached(twice(LIMITS.clip(result)))
"""


def tell(old: str = "", new: str = "") -> Any:
    """Describe the objective of the program with one change."""
    assert old in PROGRAM
    module = types.ModuleType("mine")
    sys.modules["mine"] = module
    try:
        exec(PROGRAM.replace(old, new) if old else PROGRAM, module.__dict__)
        return describe(module.objective)
    finally:
        del sys.modules["mine"]


def test_equal_programs_have_equal_descriptions() -> None:
    assert tell() == tell()
    # Unused imports and line numbers have no effect.
    assert tell() == tell("import functools, math", "import functools, math, os\n\n")


def test_descriptions_are_equal_in_another_process() -> None:
    code = f"""
import sys, types, json
from ancf.studies.definition.fingerprint import describe
module = types.ModuleType("mine")
sys.modules["mine"] = module
exec({PROGRAM!r}, module.__dict__)
print(json.dumps(describe(module.objective), sort_keys=True))
"""
    runs = [subprocess.run([sys.executable, "-c", code], capture_output=True, check=True) for _ in range(2)]
    assert runs[0].stdout == runs[1].stdout


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("Limits(1.0)", "Limits(2.0)"),
        ("low: float = 0.0", "low: float = 0.5"),
        ("max(self.low, x)", "min(self.low, x)"),
        ("default_factory=list", "default_factory=lambda: [1]"),
        ("b: float = 2.0", "b: float = 3.0"),
        ("TIP = 1", "TIP = 2"),
        ("factor * x", "factor / x"),
        ("partial(scaled, 2.0)", "partial(scaled, 3.0)"),
        ("return x + 1", "return x + 2"),
        ('{"a", "b", "c"}', '{"a", "b", "d"}'),
        ('b"raw"', 'b"row"'),
        (", None, deque", ", 0, deque"),
        ("deque([1, 2])", "deque([1, 3])"),
    ],
)
def test_descriptions_depend_on_the_environment(old: str, new: str) -> None:
    assert tell(old, new) != tell()


def test_objects_without_description_are_unique() -> None:
    thing = threading.Lock()
    assert describe(thing) != describe(thing)


def test_callable_objects_are_described_by_their_classes() -> None:
    def made(sign: int) -> Any:
        class Scale:
            def __init__(self, factor: float) -> None:
                self.factor = factor

            def __call__(self, x: float) -> float:
                return sign * self.factor * x

            def method(self, x: float) -> float:
                return self(x)

        return Scale

    one, other = made(1), made(-1)
    assert describe(one(2.0)) == describe(made(1)(2.0))
    assert describe(one(2.0)) != describe(one(3.0))
    assert describe(one(2.0)) != describe(other(2.0))
    assert describe(one(2.0).method) != describe(other(2.0).method)
    assert describe(functools.partial(one(2.0))) != describe(functools.partial(other(2.0)))


def test_mutually_calling_functions_are_described_once() -> None:
    space: dict[str, Any] = {"__name__": "mine"}
    calls = "; ".join(f"f{i}(x)" for i in range(40))
    exec("\n".join(f"def f{i}(x): {calls}" for i in range(40)), space)
    assert describe(space["f0"]) == describe(space["f0"])
