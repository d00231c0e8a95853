"""Runs of ancf, each a process of its own."""

import json
import os
import resource
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from problems import DENSITY, DIAMETER, GRAVITY, INTERVAL, LENGTH, Problem, Run

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("ANCF", ROOT / "target" / "release" / "ancf"))


# Tolerance of Newton's method: of the increment in the energy norm. The default, and a looser one.
TOLERANCES = (1e-8, 1e-5)


def model(problem: Problem, kind: str, n: int, step: float, tolerance: float) -> str:
    """A model file; `kind`: `cable` (12 coordinates), `beam` (24, the paper's), `linked` (24, without locking)."""
    body = "cable" if kind == "cable" else "beam"
    if isinstance(problem.scheme, tuple):
        beta, gamma = problem.scheme
        scheme = f"{{ beta = {beta}, gamma = {gamma} }}"
    else:
        scheme = f"{{ spectral_radius = {problem.scheme} }}"
    if problem.clamped:
        joint = 'kind = "clamp"'
    elif body == "beam":
        joint = 'kind = "revolute"\nb = "ground"\naxis = [0, 0, 1]'
    else:
        # A line has no rotation about itself; its motion stays in the plane.
        joint = 'kind = "spherical"'
    formulations = {"linked": "linked", "beam": "continuum"}
    formulation = f'formulation = "{formulations[kind]}"' if kind in formulations else ""
    return f"""
gravity = [0.0, {-GRAVITY}, 0.0]
materials.steel = {{ density = {DENSITY}, young = {problem.young} }}
sections.rod = {{ kind = "circle", diameter = {DIAMETER} }}

[[bodies]]
kind = "{body}"
name = "rod"
from = [0.0, 0.0, 0.0]
to = [{LENGTH}, 0.0, 0.0]
elements = {n}
section = "rod"
material = "steel"
{formulation}

[[joints]]
{joint}
name = "root"
a = {{ body = "rod", at = "start" }}

[[probes]]
name = "tip"
on = {{ body = "rod", at = "end" }}

[analysis]
kind = "dynamics"
duration = {problem.duration}
step = {step}
scheme = {scheme}
stop = {{ rule = "energy", tolerance = {tolerance} }}

[output]
parquet = false
interval = {INTERVAL}
"""


def run(problem: Problem, kind: str, n: int, step: float, tolerance: float = TOLERANCES[0]) -> Run:
    """A rod of n elements."""
    return solve(model(problem, kind, n, step, tolerance))


def solve(text: str) -> Run:
    """A whole process: reads the model, computes, writes; returns the mean displacement of all probes."""
    with tempfile.TemporaryDirectory() as folder:
        file, out = Path(folder) / "model.toml", Path(folder) / "out"
        file.write_text(text)
        before = used()
        command = [PROGRAM, "run", file, "--output", out, "--quiet"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        seconds = used() - before
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        with (out / "probes.csv").open() as file:
            names = file.readline().rstrip().split(",")
            rows = np.loadtxt(file, delimiter=",", ndmin=2)
        reported = json.loads((out / "summary.json").read_text())["wall_seconds"]
    axes = [[k for k, name in enumerate(names) if name.endswith(f".{axis}")] for axis in "xyz"]
    place = np.stack([rows[:, axis].mean(axis=1) for axis in axes], axis=1)
    return Run(seconds, reported, place[1:] - place[0])


def used() -> float:
    """Time of the processor of all children that have ended, s."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime
