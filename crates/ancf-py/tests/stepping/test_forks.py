"""Forked processes: their parent has threads that they have not."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

SCRIPT = """
import warnings
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import ancf

warnings.simplefilter("ignore")
STEEL = ancf.Material("steel", density=7850, young=2.1e11)


def model():
    section = ancf.Circle("round", diameter=0.02)
    rod = ancf.Beam("rod", from_=[0, 0, 0], to=[1, 0, 0], elements=600, section=section, material=STEEL)
    return ancf.Model(
        gravity=[0, 0, -9.81],
        bodies=[rod],
        joints=[ancf.Clamp("root", a=rod.start)],
        probes=[ancf.Probe("tip", on=rod.end)],
        analysis=ancf.Statics(),
    )


def deflection(_):
    result = ancf.run(model())
    moving = model()
    moving.analysis = ancf.Dynamics(duration=1, step=1e-3)
    simulation = ancf.Simulation(moving)
    simulation.step(1e-3)
    return float(result["tip.z"][-1]), float(abs(result.field("stress")).max()), simulation.time


own = deflection(0)
with ProcessPoolExecutor(2, mp_context=get_context("fork")) as pool:
    assert list(pool.map(deflection, range(3))) == [own] * 3
print("equal")
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes of this system are not forked")
def test_forked_processes_compute() -> None:
    """Models of any size run in forked processes, with equal results."""
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.stdout == "equal\n", done.stderr
