"""Times of the Python package beside those of the program, and what a sweep makes of the cores.

Run it in the environment in which `ancf` is installed, such as that of `cargo xtask python`:

    cargo build --release
    target/python/bin/python bench/python.py
"""

from __future__ import annotations

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import ancf

ROOT = Path(__file__).parents[1]
PROGRAM = os.environ.get("ANCF_PROGRAM", str(ROOT / "target" / "release" / "ancf"))
MODEL = ROOT / "models" / "cantilever.toml"
REPEATS = 15


def median(times: list[float]) -> str:
    """The median of times and their range, in milliseconds."""
    return f"{1e3 * statistics.median(times):7.1f} ms   ({1e3 * min(times):.1f} to {1e3 * max(times):.1f})"


def timed(what: Callable[[], object]) -> float:
    """Wall-clock time of a call."""
    start = time.perf_counter()
    what()
    return time.perf_counter() - start


def cantilever() -> None:
    """20 elements, 2000 steps, in turns, so that all meet the same load of the machine."""
    folder = tempfile.mkdtemp()
    model = ancf.Model.read(MODEL)
    ways: dict[str, Callable[[], object]] = {
        "the program, whole process with files": lambda: subprocess.run(
            [PROGRAM, "run", "--quiet", str(MODEL), "-o", folder], check=True, capture_output=True
        ),
        "ancf.run in Python, from the file": lambda: ancf.run(MODEL),
        "ancf.run in Python, typed objects": lambda: ancf.run(model),
        "ancf.run with a callback at each step": lambda: ancf.run(model, callback=lambda _: None),
        "a new Python process": lambda: subprocess.run(
            [sys.executable, "-c", f"import ancf; ancf.run({str(MODEL)!r})"], check=True
        ),
        "a new Python process that only imports": lambda: subprocess.run(
            [sys.executable, "-c", "import ancf"], check=True
        ),
    }
    times: dict[str, list[float]] = {name: [] for name in ways}
    for _ in range(REPEATS):
        for name, way in ways.items():
            times[name].append(timed(way))
    print("cantilever, 20 elements, 2000 steps")
    for name, found in times.items():
        print(f"  {name:42} {median(found)}")
    least = {name: min(found) for name, found in times.items()}
    program, python = (least[name] for name in list(ways)[:2])
    print(f"  overhead of Python, least times: {100 * (python / program - 1):+.1f} %")


def sweep() -> None:
    """200 cases on all cores."""
    factors = [0.5 + 0.005 * k for k in range(200)]

    def mean(result: ancf.Result) -> float:
        return float(result["tip.y"].mean())

    before, start = resource.getrusage(resource.RUSAGE_SELF), time.perf_counter()
    young = [193e9 * factor for factor in factors]
    study = ancf.study(MODEL, {"bodies.beam.material.young": young}, mean, progress=False)
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_SELF)
    work = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    cores = len(os.sched_getaffinity(0))
    print(f"sweep of {len(study.table)} cases of 20 elements, 2000 steps: {wall:.1f} s")
    print(f"  {work:.1f} s of processor time: {100 * work / wall / cores:.0f} % of {cores} cores")


if __name__ == "__main__":
    cantilever()
    sweep()
