"""Files for ParaView, read back with PyVista."""

from __future__ import annotations

import csv
import json
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv

ROOT = Path(__file__).parents[4]

CANTILEVER = """
units = { length = "m", time = "s", force = "N" }
materials.steel = { density = 1000, young = 2e9 }
sections.bar = { kind = "rectangle", height = 0.02, width = 0.01 }
[[bodies]]
kind = "beam"
name = "beam"
from = [0, 0, 0]
to = [2, 0, 0]
elements = 8
formulation = "linked"
section = "bar"
material = "steel"
[[joints]]
kind = "clamp"
name = "root"
a = { body = "beam", at = "start" }
[[loads]]
kind = "force"
on = { body = "beam", at = "end" }
force = [5, -0.003, 0]
[[probes]]
name = "tip"
on = { body = "beam", at = "end" }
[analysis]
kind = "statics"
"""
"""Pulled and bent a little, about z: y is along the height of the section."""


@pytest.fixture(scope="session")
def cantilever(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the run of a cantilever, in statics, with its files for ParaView."""
    folder = tmp_path_factory.mktemp("cantilever")
    (folder / "cantilever.toml").write_text(CANTILEVER, encoding="utf-8")
    return exported(program, folder / "cantilever.toml", folder / "out")


@pytest.fixture(scope="session")
def swing(program: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the run of a motion."""
    folder = tmp_path_factory.mktemp("swing")
    return exported(program, shortened(folder, "cantilever.toml", 0.3), folder / "out")


def shortened(folder: Path, name: str, duration: float) -> Path:
    """A model of the repository with another duration."""
    lines = (ROOT / "models" / name).read_text(encoding="utf-8").splitlines()
    lines = [f"duration = {duration}" if line.startswith("duration") else line for line in lines]
    (folder / name).write_text("\n".join(lines), encoding="utf-8")
    return folder / name


def exported(program: Path, model: Path, out: Path, *options: str) -> Path:
    """The folder of a run, with its files for ParaView."""
    subprocess.run([program, "run", model, "-o", out], check=True, capture_output=True)
    subprocess.run([program, "paraview", out, *options], check=True, capture_output=True)
    return out


def frames(out: Path, name: str) -> list[tuple[float, Any]]:
    """Times and grids of a collection."""
    reader = pv.PVDReader(str(out / "paraview" / f"{name}.pvd"))
    found = []
    for value in reader.time_values:
        reader.set_active_time_value(value)
        found.append((value, reader.read()[0]))
    return found


def columns(out: Path) -> dict[str, np.ndarray]:
    """The columns of `probes.csv`."""
    with (out / "probes.csv").open(encoding="utf-8") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, np.array(rows, dtype=float).T, strict=True))


def test_times_and_displacements_are_those_of_the_probes(swing: Path) -> None:
    table = columns(swing)
    lines = frames(swing, "lines")
    assert len(lines) > 10
    assert np.all(np.diff([value for value, _ in lines]) > 0)
    start = np.array([table[f"tip.{axis}"][0] for axis in "xyz"])
    for value, grid in lines:
        row = int(np.argmin(np.abs(table["t"] - value)))
        assert table["t"][row] == pytest.approx(value, abs=1e-12)
        tip = np.array([table[f"tip.{axis}"][row] for axis in "xyz"])
        velocity = np.array([table[f"tip.v{axis}"][row] for axis in "xyz"])
        end = int(np.argmax(grid["s"]))
        np.testing.assert_allclose(grid.points[end], tip, rtol=0, atol=1e-9)
        np.testing.assert_allclose(grid["displacement"][end], tip - start, rtol=0, atol=1e-9)
        np.testing.assert_allclose(grid["velocity"][end], velocity, rtol=1e-9, atol=1e-9)


def test_surfaces_are_closed_and_bounded_by_their_sections(swing: Path) -> None:
    for (_, skin), (_, line) in zip(frames(swing, "sections"), frames(swing, "lines"), strict=True):
        surface = skin.extract_surface(algorithm=None)
        assert surface.n_open_edges == 0
        assert surface.is_manifold
        assert surface.volume > 0
        lower, upper = np.array(skin.bounds).reshape(3, 2).T
        assert np.all(line.points >= lower - 1e-9)
        assert np.all(line.points <= upper + 1e-9)


def test_a_straight_rod_has_the_volume_of_its_prism(swing: Path) -> None:
    """A circle is drawn as a polygon of 24 sides, whose area is 12 r² sin 15°."""
    _, skin = frames(swing, "sections")[0]
    _, line = frames(swing, "lines")[0]
    radius, length = skin.bounds[3], line["s"].max()
    assert skin.bounds[1] - skin.bounds[0] == pytest.approx(length)
    volume = skin.extract_surface(algorithm=None).triangulate().volume
    assert volume == pytest.approx(12 * radius**2 * np.sin(np.pi / 12) * length, rel=1e-5)


def test_section_forces_at_the_clamp_are_those_of_statics(cantilever: Path) -> None:
    _, line = frames(cantilever, "lines")[-1]
    tip = line.points[-1]
    assert line["N"][0] == pytest.approx(5, rel=1e-4)
    assert line["Mz"][0] == pytest.approx(tip[0] * -0.003 - tip[1] * 5, rel=1e-4)
    np.testing.assert_allclose(line["T"], 0, atol=1e-8)


def test_stress_on_top_and_bottom_is_that_of_bending(cantilever: Path) -> None:
    """σ = N/A ∓ M (h/2) / I."""
    _, line = frames(cantilever, "lines")[-1]
    _, skin = frames(cantilever, "sections")[-1]
    root = np.isclose(skin["s"], 0)
    moment, second = line["Mz"][0], 0.01 * 0.02**3 / 12
    for side in [-1, 1]:
        points = root & np.isclose(skin.points[:, 1], side * 0.01)
        assert points.sum() == 2
        stress = 5 / 2e-4 - moment * side * 0.01 / second
        np.testing.assert_allclose(skin["stress"][points], stress, rtol=1e-4)
        np.testing.assert_allclose(skin["strain"][points], stress / 2e9, rtol=0.05)


def test_files_say_where_they_come_from(cantilever: Path) -> None:
    for name in ["sections", "lines"]:
        _, grid = frames(cantilever, name)[-1]
        about = grid.field_data
        assert about["model"][0] == CANTILEVER
        assert about["program"][0].startswith("ancf ")
        assert about["bodies"][0] == "beam"
        units = json.loads(about["units"][0])
        assert units["stress"] == "N/m²"
        assert set(grid.point_data) <= set(units)
        assert set(grid.cell_data["body"]) == {0}


def test_shapes_warp(program: Path, tmp_path: Path) -> None:
    out = exported(program, ROOT / "models" / "tuning_fork.toml", tmp_path / "out")
    shapes = frames(out, "sections")
    assert [value for value, _ in shapes] == list(range(1, len(shapes) + 1))
    still = shapes[0][1].warp_by_vector("shape", factor=-1).points
    for _, grid in shapes:
        assert np.abs(grid["shape"]).max() > 0
        np.testing.assert_allclose(grid.warp_by_vector("shape", factor=-1).points, still, atol=1e-6)


def test_frames_are_thinned_and_chosen(program: Path, swing: Path, tmp_path: Path) -> None:
    out = tmp_path / "few"
    subprocess.run(
        [program, "paraview", swing, "-o", out, "--frames", "4", "--from", "0.1", "--to", "0.2"], check=True
    )
    times = pv.PVDReader(str(out / "lines.pvd")).time_values
    assert len(times) == 4
    assert min(times) >= 0.1
    assert max(times) <= 0.2
    none = subprocess.run(
        [program, "paraview", swing, "--from", "100"], capture_output=True, check=False, text=True
    )
    assert none.returncode == 2
    assert "no frame" in none.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="kills by a signal")
def test_a_killed_run_gives_what_there_is(program: Path, tmp_path: Path) -> None:
    model = shortened(tmp_path, "cantilever.toml", 1000.0)
    out = tmp_path / "out"
    run = subprocess.Popen([program, "run", model, "-o", out], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    parts = out / "states.parquet.parts"
    wait = time.monotonic() + 60
    while not any(parts.glob("part-*.parquet")) and time.monotonic() < wait:
        time.sleep(0.05)
    # During the run, and after its end.
    subprocess.run([program, "paraview", out], check=True, capture_output=True)
    run.send_signal(signal.SIGKILL)
    run.communicate()
    shutil.rmtree(out / "paraview")
    subprocess.run([program, "paraview", out], check=True, capture_output=True)
    assert frames(out, "sections")[0][1].extract_surface(algorithm=None).n_open_edges == 0
