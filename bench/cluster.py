"""A study of many short cases on a local cluster of two processes, of which one is killed in the middle.

Run it in the environment in which `ancf` is installed, such as that of `cargo xtask python`:

    target/python/bin/python bench/cluster.py [CASES]

It states the cost per case, counts the executions of each case, and checks every row against a closed form.
"""

from __future__ import annotations

import os
import resource
import signal
import sys
import tempfile
import threading
import time
from collections import Counter
from pathlib import Path

import numpy as np
from distributed import Client, LocalCluster

import ancf

CASES = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
LENGTH, DIAMETER, YOUNG = 1.0, 0.02, 2.1e11
EXECUTED = "ANCF_EXECUTED"
"""Environment variable with the file to which each execution of a case appends its process and load."""


def model() -> dict[str, object]:
    """A cantilever of one element with a small force at its end."""
    return {
        "scales": {"kind": "auto"},
        "materials": {"steel": {"density": 7850, "young": YOUNG, "poisson": 0.3}},
        "sections": {"bar": {"kind": "circle", "diameter": DIAMETER}},
        "bodies": [
            {
                "kind": "cable",
                "name": "arm",
                "from": [0.0, 0.0, 0.0],
                "to": [LENGTH, 0.0, 0.0],
                "elements": 1,
                "section": "bar",
                "material": "steel",
            }
        ],
        "joints": [{"kind": "clamp", "name": "root", "a": {"body": "arm", "at": "start"}}],
        "loads": [{"kind": "force", "on": {"body": "arm", "at": "end"}, "force": [0.0, 0.0, -1.0]}],
        "probes": [{"name": "tip", "on": {"body": "arm", "at": "end"}}],
        "analysis": {"kind": "statics"},
        "output": {"states": 0},
    }


def deflection(result: ancf.Result) -> float:
    """Deflection of the end; appends a line to the file of executions."""
    last = float(result["tip.z"][-1])
    with Path(os.environ[EXECUTED]).open("a") as file:
        file.write(f"{os.getpid()} {last!r}\n")
    return last


def kill_when(cluster: LocalCluster, share: float) -> None:
    """Kill a worker when a share of the cases has been executed."""
    file = Path(os.environ[EXECUTED])
    while not file.exists() or sum(1 for _ in file.open()) < share * CASES:
        time.sleep(0.2)
    pid = next(iter(cluster.workers.values())).pid
    os.kill(pid, signal.SIGKILL)
    print(f"killed the worker of process {pid} at {share:.0%} of the cases; the cluster starts another")


def main() -> None:
    """Run the study and state what it cost."""
    folder = Path(tempfile.mkdtemp())
    os.environ[EXECUTED] = str(folder / "executed")
    os.environ["RAYON_NUM_THREADS"] = "1"
    loads = np.linspace(0.01, 1.0, CASES)
    with LocalCluster(n_workers=2, threads_per_worker=1) as cluster, Client(cluster) as client:
        threading.Thread(target=kill_when, args=(cluster, 0.5), daemon=True).start()
        start = time.perf_counter()
        parameters = {"loads[0].force": [[0.0, 0.0, -float(load)] for load in loads]}
        study = ancf.study(model(), parameters, {"z": deflection}, client=client, folder=folder / "study")
        seconds = time.perf_counter() - start
    executed = Counter(line.split()[1] for line in (folder / "executed").open())
    table = study.table
    inertia = np.pi * DIAMETER**4 / 64
    expected = -loads * LENGTH**3 / (3 * YOUNG * inertia)
    error = np.max(np.abs(table["z"].to_numpy() / expected - 1))
    size = (folder / "study" / "cases.parquet").stat().st_size
    used = resource.getrusage(resource.RUSAGE_SELF)
    processor = 1e3 * (used.ru_utime + used.ru_stime) / CASES
    print(
        f"rows {len(table)}, of them finished {len(study.finished)}, cases twice {len(table) - table['case'].nunique()}"
    )
    print(
        f"cases without an execution {CASES - len(executed)}, executions in addition {executed.total() - CASES}"
    )
    print(f"largest deviation from F L^3/(3 E I) {error:.1e}")
    print(f"{seconds:.1f} s, {1e3 * seconds / CASES:.2f} ms a case")
    print(f"of which solution {1e3 * table['seconds'].mean():.2f} ms on each of two processes")
    print(f"client and scheduler {used.ru_maxrss / 1024:.0f} MB, {processor:.2f} ms a case")
    print(f"table {size / CASES:.0f} bytes a case")


if __name__ == "__main__":
    main()
