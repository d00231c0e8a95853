"""Models of several tests."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import ancf

ROOT = Path(__file__).parents[3]


@pytest.fixture(autouse=True)
def _ctrl_c() -> Iterator[None]:
    """Let Ctrl-C reach Python, also in the background of a shell, which ignores it."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="session")
def program() -> Path:
    """The program `ancf`: the one that `ANCF_PROGRAM` names, else the workspace's."""
    named = os.environ.get("ANCF_PROGRAM")
    if named is not None:
        return Path(named)
    built = ROOT / "target" / "debug" / f"ancf{'.exe' if os.name == 'nt' else ''}"
    subprocess.run(["cargo", "build", "--quiet", "--workspace", "--bins", "--examples"], cwd=ROOT, check=True)
    return built


@pytest.fixture
def models() -> Path:
    """The folder of example models."""
    return ROOT / "models"


@pytest.fixture
def rod() -> dict[str, Any]:
    """Plain data of a pendulum rod."""
    return {
        "gravity": [0, -9.81, 0],
        "materials": {"plastic": {"density": 2000.0, "young": 5e9}},
        "sections": {"strip": {"kind": "rectangle", "width": 0.05, "height": 0.02}},
        "bodies": [
            {
                "kind": "beam",
                "name": "arm",
                "from": [0, 0, 0],
                "to": [1, 0, 0],
                "elements": 4,
                "section": "strip",
                "material": "plastic",
            }
        ],
        "joints": [
            {
                "kind": "revolute",
                "name": "pivot",
                "a": {"body": "arm", "at": "start"},
                "axis": [0, 0, 1],
            }
        ],
        "probes": [
            {
                "name": "tip",
                "on": {"body": "arm", "at": "end"},
                "record": ["motion", "rotation", "section_forces", "strain", "stress"],
            }
        ],
        "analysis": {"kind": "dynamics", "duration": 0.3, "step": 1e-3},
    }


@pytest.fixture
def bar(models: Path) -> dict[str, Any]:
    """A bar of steel in equilibrium under its own weight."""
    return ancf.Model.read(models / "cantilever.toml").to_dict() | {"analysis": {"kind": "statics"}}


@pytest.fixture
def pushed(bar: dict[str, Any]) -> dict[str, Any]:
    """The bar with a small force at its tip instead."""
    push = {"kind": "force", "on": {"body": "beam", "at": "end"}, "force": [0, -0.1, 0]}
    return bar | {"gravity": [0, 0, 0], "loads": [push]}
