"""Results of the command line, read by Python."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest

import ancf

ROOT = Path(__file__).parents[4]


def start(program: Path, model: dict[str, Any], folder: Path) -> subprocess.Popen[bytes]:
    """Start the program on a model; its results go into `folder / "out"`."""
    file = folder / "model.toml"
    ancf.Model.from_dict(model).write(file)
    command = [str(part) for part in (program, "run", file, "-o", folder / "out", "--quiet")]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def folder_of(program: Path, model: dict[str, Any], folder: Path) -> Path:
    """The folder of a completed run."""
    run = start(program, model, folder)
    _, text = run.communicate()
    assert run.returncode == 0, text
    return folder / "out"


def test_columns_and_fields_equal_a_run_in_python(program: Path, rod: dict[str, Any], tmp_path: Path) -> None:
    model = rod | {"output": {"states": 31}, "units": {"length": "m", "time": "s", "force": "N"}}
    here, loaded = ancf.run(model), ancf.load(folder_of(program, model, tmp_path))
    assert loaded.columns == here.columns
    np.testing.assert_array_equal(loaded.data, here.data)
    # Some 31 instants of 301 rows, the first and the last among them.
    rows = loaded.frame_rows
    assert rows[0] == 0
    assert rows[-1] == 300
    assert 30 <= len(rows) <= 32
    np.testing.assert_array_equal(loaded.frames, here.time[rows])
    for name in ["position", "displacement", "velocity", "acceleration", "directors", "section_forces"]:
        np.testing.assert_array_equal(loaded.field(name, parts=2), here.field(name, parts=2)[rows])
    np.testing.assert_array_equal(loaded.field("position", rows=-1), here.field("position", rows=-1))
    assert loaded.kind == "dynamics"
    assert loaded.units == here.units
    assert loaded.summary["outcome"] == {"kind": "finished"}
    assert {key: loaded.summary[key] for key in here.summary} == here.summary
    assert loaded.model["bodies"] == here.model["bodies"]


@pytest.mark.parametrize("analysis", ["statics", "modes", "buckling"])
def test_results_without_time_have_all_states(
    analysis: str, program: Path, models: Path, tmp_path: Path
) -> None:
    file = {"statics": "elastica", "modes": "tuning_fork", "buckling": "column"}[analysis]
    model = ancf.Model.read(models / f"{file}.toml").to_dict()
    here, loaded = ancf.run(model), ancf.load(folder_of(program, model, tmp_path))
    assert loaded.kind == analysis
    np.testing.assert_array_equal(loaded.data, here.data)
    np.testing.assert_array_equal(loaded.frame_rows, np.arange(len(here)))
    np.testing.assert_array_equal(loaded.field("position"), here.field("position"))
    if analysis != "statics":
        np.testing.assert_array_equal(loaded.shapes, here.shapes)


def test_states_between_rows_keep_their_times(program: Path, rod: dict[str, Any], tmp_path: Path) -> None:
    whole = ancf.run(rod)
    model = rod | {"output": {"every": 7, "states": 31}}
    loaded = ancf.load(folder_of(program, model, tmp_path))
    np.testing.assert_array_equal(loaded.data, whole.data[[*range(0, 301, 7), 300]])
    steps = np.searchsorted(whole.time, loaded.frames)
    np.testing.assert_array_equal(whole.time[steps], loaded.frames)
    np.testing.assert_array_equal(loaded.field("position"), whole.field("position")[steps])
    # States of rows have the number of the row.
    has = loaded.frame_rows >= 0
    np.testing.assert_array_equal(has, (steps % 7 == 0) | (steps == 300))
    np.testing.assert_array_equal(loaded.time[loaded.frame_rows[has]], loaded.frames[has])
    fields = loaded.to_xarray(fields=["position"])
    assert fields["position"].dims == ("frame", "station", "axis")
    np.testing.assert_array_equal(fields["frame"], loaded.frames)
    near = fields["position"].sel(frame=0.1, method="nearest")
    np.testing.assert_allclose(near[-1, 0], np.interp(0.1, loaded.time, loaded["tip.x"]), atol=1e-3)


def test_plots_use_the_times_of_the_states(program: Path, rod: dict[str, Any], tmp_path: Path) -> None:
    loaded = ancf.load(folder_of(program, rod | {"output": {"states": 11}}, tmp_path))
    ax = loaded.plot_shape(time=0.15, reference=False, joints=False)
    frame = int(np.abs(loaded.frames - 0.15).argmin())
    assert ax.get_title() == f"t = {loaded.frames[frame]:.4g}"
    tip = np.array(ax.get_lines()[-1].get_xydata())[-1]
    np.testing.assert_allclose(tip, loaded.probe("tip").position[loaded.frame_rows[frame], :2], rtol=1e-9)
    # 0.3 at a hundredth of the speed take 30 s, of which the last frame is the last state.
    film: Any = loaded.animate(speed=0.01, fps=1, parts=1, save=tmp_path / "rod.gif")
    frames = list(film.new_frame_seq())
    assert (len(frames), frames[0], frames[-1]) == (31, 0, len(loaded.frames) - 1)
    np.testing.assert_allclose(loaded.frames[frames], np.linspace(0, 0.3, 31), atol=0.0151)
    film._draw_frame(frames[-1])
    assert film._fig.axes[0].get_title(loc="left").startswith("t = 0.300")
    with pytest.raises(IndexError, match=rf"frame {len(loaded.frames)}: the result has \d+ states"):
        loaded.plot_shape(len(loaded.frames))
    plt.close("all")


def test_loaded_results_are_pickled(program: Path, rod: dict[str, Any], tmp_path: Path) -> None:
    loaded = ancf.load(folder_of(program, rod, tmp_path))
    again = pickle.loads(pickle.dumps(loaded))
    np.testing.assert_array_equal(again.data, loaded.data)
    np.testing.assert_array_equal(again.frames, loaded.frames)
    np.testing.assert_array_equal(again.field("section_forces"), loaded.field("section_forces"))


@pytest.mark.parametrize("file", ["results.parquet", "states.parquet", "summary.json", "model.toml"])
def test_damaged_files_are_rejected(file: str, program: Path, rod: dict[str, Any], tmp_path: Path) -> None:
    folder = folder_of(program, rod, tmp_path)
    whole = (folder / file).read_bytes()
    for place in (len(whole) // 3, len(whole) // 2):
        damaged = bytearray(whole)
        damaged[place] ^= 0x40
        (folder / file).write_bytes(damaged)
        with pytest.raises(OSError, match=file.replace(".", r"\.")):
            ancf.load(folder)
    (folder / file).write_bytes(whole)
    ancf.load(folder)


@pytest.mark.skipif(os.name == "nt", reason="SIGKILL")
def test_a_run_in_progress_and_a_killed_run(program: Path, rod: dict[str, Any], tmp_path: Path) -> None:
    endless = rod | {"analysis": rod["analysis"] | {"duration": 100.0}, "output": {"states": 20001}}
    run = start(program, endless, tmp_path)
    try:
        going = wait_for(tmp_path / "out")
        assert going.summary["outcome"]["kind"] == "running"
        assert "running" in repr(going)
    finally:
        run.send_signal(signal.SIGKILL)
        run.communicate()
    broken = ancf.load(tmp_path / "out")
    assert broken.summary["outcome"]["kind"] == "broken"
    assert "killed" in broken.summary["outcome"]["reason"]
    assert broken.summary["coordinates"] == going.summary["coordinates"] > 0
    assert len(broken) >= len(going) > 0
    # The results so far equal those of a shorter run.
    count = min(len(broken), 200)
    short = rod | {"analysis": rod["analysis"] | {"duration": 1e-3 * (count - 1)}}
    here = ancf.run(short)
    np.testing.assert_allclose(broken.data[:count], here.data, rtol=1e-9, atol=1e-9)
    kept = broken.frame_rows[(broken.frame_rows >= 0) & (broken.frame_rows < count)]
    assert len(kept)
    np.testing.assert_allclose(
        broken.field("position")[: len(kept)], here.field("position")[kept], rtol=1e-9, atol=1e-12
    )
    assert "killed" in broken.report().html


def wait_for(folder: Path) -> ancf.Result:
    """The results in a folder, once there are rows and states."""
    for _ in range(600):
        time.sleep(0.1)
        try:
            result = ancf.load(folder)
        except FileNotFoundError:
            continue
        if len(result) > 1 and len(result.frames) > 1:
            return result
    msg = "no rows in a minute"
    raise TimeoutError(msg)


def test_a_run_without_states_reports_it(program: Path, rod: dict[str, Any], tmp_path: Path) -> None:
    loaded = ancf.load(folder_of(program, rod | {"output": {"states": 0}}, tmp_path))
    assert len(loaded) == 301
    assert len(loaded.frames) == 0
    wants: list[Callable[[], object]] = [loaded.plot_shape, loaded.animate, loaded.report]
    for what in [lambda: loaded.field("position"), *wants]:
        with pytest.raises(ValueError, match=r"kept no such states; .*`output\.states` > 0"):
            what()


def test_errors_of_folders(program: Path, rod: dict[str, Any], tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"nothing contains no run: there is no model\.toml"):
        ancf.load(tmp_path / "nothing")
    out = folder_of(program, rod, tmp_path)
    model = (out / "model.toml").read_text()
    (out / "model.toml").write_text("ends = 3\n" + model)
    with pytest.raises(OSError, match=r"model\.toml: the file is damaged: it is not the model of this run"):
        ancf.load(out)
    (out / "model.toml").write_text(model)
    for name in ["states.parquet", "results.parquet"]:
        good = (out / name).read_bytes()
        (out / name).write_bytes(good[: len(good) // 2])
        with pytest.raises(OSError, match=name.replace(".", r"\.")):
            ancf.load(out)
        (out / name).write_bytes(good)
    other = model.replace('name = "tip"', 'name = "top"')
    assert other != model
    (out / "model.toml").write_text(other)
    with pytest.raises(OSError, match=r"model\.toml: the file is damaged"):
        ancf.load(out)
