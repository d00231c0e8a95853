"""Studies on a cluster of processes, some of which die."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from distributed import Client, LocalCluster

import ancf


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    """Two processes with a thread each."""
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0") as cluster,
        Client(cluster) as client,
    ):
        yield client


def logged(folder: Path, seconds: float) -> Any:
    """An objective that leaves a file for each call, with its process, and takes some time."""

    def objective(result: ancf.Result) -> float:
        name = f"{result.model['bodies'][0]['to'][0]}-{os.getpid()}-{time.time_ns()}"
        (folder / name).touch()
        time.sleep(seconds)
        return float(result["tip.y"][-1])

    return objective


def test_a_cluster_gives_the_results_of_threads(client: Client, rod: dict[str, Any], tmp_path: Path) -> None:
    parameters = {
        "bodies.arm.elements": [1, 2, 0, 3],
        "loads": [
            [],
            [{"kind": "force", "on": {"body": "arm", "at": "end"}, "force": [0, 1, 0], "time": np.sin}],
        ],
    }
    here = ancf.study(rod, parameters, lambda result: result["tip.y"].min())
    there = ancf.study(rod, parameters, lambda result: result["tip.y"].min(), client=client, folder=tmp_path)
    assert list(here.table["outcome"]).count("invalid") == 2
    rest = [column for column in here.table if column not in {"seconds", "key"}]
    pd.testing.assert_frame_equal(here.table[rest], there.table[rest])
    assert (tmp_path / "cases.parquet").exists()


def test_no_case_is_lost_with_a_worker(client: Client, rod: dict[str, Any], tmp_path: Path) -> None:
    lengths = list(np.linspace(1.0, 1.2, 120))
    parameters = {"bodies.arm.to": [[length, 0, 0] for length in lengths], "analysis.duration": [0.02]}
    pids = sorted(client.run(os.getpid).values())
    killed = []

    def kill() -> None:
        while len(list(tmp_path.iterdir())) < 30:
            time.sleep(0.01)
        os.kill(pids[0], signal.SIGKILL)
        killed.append(len(list(tmp_path.iterdir())))

    killer = threading.Thread(target=kill)
    killer.start()
    study = ancf.study(rod, parameters, logged(tmp_path, 0.05), client=client)
    killer.join()
    assert 30 <= killed[0] < 110, "it was killed in the middle"
    assert list(study.table["case"]) == list(range(120))
    assert list(study.table["outcome"]) == ["finished"] * 120
    single = ancf.study(rod, parameters, {"tip": "tip.y"})
    np.testing.assert_array_equal(study.table["objective"], single.table["tip"])
    workers = {int(path.name.split("-")[1]) for path in tmp_path.iterdir()}
    assert pids[0] in workers
    assert pids[0] not in client.run(os.getpid).values()


def test_a_case_that_kills_its_workers_is_a_row(client: Client, rod: dict[str, Any]) -> None:
    def objective(result: ancf.Result) -> float:
        if result.model["bodies"][0]["elements"] == 3:
            os.kill(os.getpid(), signal.SIGKILL)
        return float(result["tip.y"][-1])

    elements = [1, 2, 3, *range(4, 20)]
    study = ancf.study(rod, {"elements": elements, "analysis.duration": [0.01]}, objective, client=client)
    outcomes = dict(zip(study.table["elements"], study.table["outcome"], strict=True))
    assert outcomes == dict.fromkeys(elements, "finished") | {3: "failed"}
    assert str(study.failed["message"].iloc[0]).startswith("KilledWorker: ")


def test_an_interrupt_keeps_finished_cases_of_a_cluster(
    client: Client, rod: dict[str, Any], tmp_path: Path
) -> None:
    calls = tmp_path / "calls"
    calls.mkdir()

    def interrupt() -> None:
        while len(list(calls.iterdir())) < 20:
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    parameters = {
        "bodies.arm.to": [[length, 0, 0] for length in np.linspace(1, 1.2, 400)],
        "analysis.duration": [0.01],
    }
    watcher = threading.Thread(target=interrupt)
    watcher.start()
    with pytest.raises(KeyboardInterrupt):
        ancf.study(rod, parameters, logged(calls, 0.05), client=client, folder=tmp_path)
    watcher.join()
    kept = pd.read_parquet(tmp_path / "cases.parquet")
    assert 0 < len(kept) < 400
    assert set(kept["outcome"]) == {"finished"}
