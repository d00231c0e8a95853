"""Reports of results, and units of axes."""

from __future__ import annotations

import base64
import gzip
import json
import re
import struct
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest

import ancf

UNITS = {"length": "m", "time": "s", "force": "N"}
TYPES = {"f32": "<f4", "f64": "<f8", "i16": "<i2", "u16": "<u2", "u32": "<u4"}


class Scene:
    """The scene in a page."""

    def __init__(self, html: str) -> None:
        """The scene in the text of a page."""
        found = re.search(r'<script type="application/octet-stream" id="scene">([^<]+)</script>', html)
        assert found is not None
        container = gzip.decompress(base64.b64decode(found[1]))
        magic, version, length, _ = struct.unpack_from("<4sIII", container)
        assert (magic, version) == (b"ANCF", 1)
        self.header: dict[str, Any] = json.loads(container[16 : 16 + length])
        self._blob = container[16 + length :]

    def array(self, of: dict[str, Any]) -> Any:
        """An array of the header."""
        return np.frombuffer(self._blob, TYPES[of["type"]], of["count"], of["at"])

    def columns(self) -> dict[str, tuple[str, Any]]:
        """Unit and numbers of all columns of charts."""
        charts = self.header["charts"]
        return {
            column["name"]: (column["unit"], self.array(column["values"]))
            for chart in charts
            for column in chart["columns"]
        }


@pytest.fixture
def named(rod: dict[str, Any]) -> dict[str, Any]:
    """The rod with named units."""
    return rod | {"units": UNITS, "title": "A <rod>", "output": {"every": 3}}


def test_a_report_has_the_motion_and_the_columns(named: dict[str, Any], tmp_path: Path) -> None:
    result = ancf.run(named)
    result.report(tmp_path / "rod.html")
    html = (tmp_path / "rod.html").read_text(encoding="utf-8")
    assert "<title>A &lt;rod&gt;</title>" in html
    assert not re.search(r'(?:src|href)="https?:', html)
    scene = Scene(html)
    header = scene.header
    assert header["units"] == UNITS
    assert header["outcome"] == {"kind": "finished", "message": ""}
    assert dict(header["summary"])["steps"] == str(result.summary["steps"])
    np.testing.assert_array_equal(scene.array(header["frames"]["values"]), result.time)
    centres = scene.array(header["centres"]).reshape(len(result), header["stations"], 3)
    np.testing.assert_allclose(centres[:, -1], result.probe("tip").position, atol=1e-6)
    columns = scene.columns()
    unit, numbers = columns["tip.y"]
    assert unit == "m"
    np.testing.assert_allclose(numbers, result["tip.y"], rtol=1e-6, atol=1e-7)
    (pivot,) = header["reactions"]
    assert pivot["name"] == "pivot"
    force = scene.array(pivot["force"]).reshape(-1, 3)
    # Accelerations and multipliers are of the states, so that arrows are what was recorded.
    recorded = result.reactions["pivot"].force
    np.testing.assert_allclose(force, recorded, rtol=1e-5, atol=1e-5 * np.abs(recorded).max())


def test_a_custom_title_and_a_frame_in_a_notebook(rod: dict[str, Any]) -> None:
    report = ancf.run(rod).report(title='"Swing" & more')
    assert Scene(report.html).header["title"] == '"Swing" & more'
    assert Scene(report.html).header["units"] is None
    shown = report._repr_html_()
    assert shown.startswith("<iframe sandbox=")
    # Quotes within the page are escaped.
    assert shown.count('"') == 2 * shown.count('="')
    assert re.fullmatch(r"Report\(\d+\.\d MB\)", repr(report))


def test_reports_of_analyses_without_time(models: Path) -> None:
    modes = ancf.run(models / "tuning_fork.toml")
    header = Scene(modes.report().html).header
    assert (header["analysis"], header["frames"]["count"]) == ("modes", len(modes))
    assert len(header["frames"]["labels"]) == len(modes)


def test_a_report_of_a_failure_has_the_reason(rod: dict[str, Any]) -> None:
    stiff = rod | {"analysis": rod["analysis"] | {"step": 0.1, "max_iterations": 1, "max_halvings": 0}}
    with pytest.raises(ancf.AnalysisError) as caught:
        ancf.run(stiff)
    assert caught.value.result is not None
    outcome = Scene(caught.value.result.report().html).header["outcome"]
    assert outcome == {"kind": "failed", "message": str(caught.value)}


def test_a_model_with_functions_has_a_report(rod: dict[str, Any]) -> None:
    tip = {"body": "arm", "at": "end"}
    push = {"kind": "force", "on": tip, "force": [0, 1, 0], "time": lambda t: 5 * t}
    result = ancf.run(rod | {"loads": [push]})
    header = Scene(result.report().html).header
    assert header["frames"]["count"] == len(result)


def test_a_report_needs_complete_states(rod: dict[str, Any]) -> None:
    for states in ("positions", "none"):
        result = ancf.run(rod, states=states)
        with pytest.raises(ValueError, match='report: the run kept no such states; run it with states="all"'):
            result.report()


def test_axes_have_the_units_of_the_model(named: dict[str, Any]) -> None:
    result = ancf.run(named)
    expected = {"t": "s", "tip.x": "m", "tip.vx": "m/s", "tip.ax": "m/s²", "tip.e0": "1", "tip.N": "N"}
    expected |= {"tip.Mz": "N m", "tip.sxx": "N/m²", "kinetic": "J", "pivot.rate": "rad/s"}
    assert expected.items() <= result.units.items()
    fields = {
        "position": "x",
        "velocity": "vx",
        "acceleration": "ax",
        "N": "N",
        "Qz": "Qz",
        "T": "T",
        "My": "My",
    }
    for field, column in fields.items():
        assert result.field_units[field] == result.units[f"tip.{column}"]
    ax = result.plot("tip.velocity")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("time, s", "velocity, m/s")
    ax = result.plot("tip.y", x="tip.x")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("tip.x, m", "tip.y, m")
    assert result.plot("energy").get_ylabel() == "energy, J"
    assert result.plot("tip.e1").get_ylabel() == "tip.e1"
    ax = result.plot_shape(color="Mz", plane="xy")
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("x, m", "y, m")
    assert ax.get_title() == "t = 0.3 s"
    assert [axes.get_ylabel() for axes in ax.figure.axes[1:]] == ["bending moment Mz, N m"]
    plt.close("all")


def test_tables_have_the_units_of_the_model(named: dict[str, Any], rod: dict[str, Any]) -> None:
    result = ancf.run(named)
    assert result.to_pandas().attrs["units"] == result.units
    data = result.to_xarray(fields=["velocity", "section_forces"])
    assert data["t"].attrs["units"] == "s"
    assert data["s"].attrs["units"] == "m"
    assert data["tip.ax"].attrs["units"] == "m/s²"
    assert data["velocity"].attrs["units"] == "m/s"
    # Components are in different units.
    assert "units" not in data["section_forces"].attrs
    plain = ancf.run(rod)
    assert plain.units == plain.field_units == {}
    assert "units" not in plain.to_pandas().attrs
    assert plain.to_xarray()["t"].attrs == {}


def test_shapes_have_no_unit(models: Path) -> None:
    modes = ancf.run(ancf.Model.read(models / "tuning_fork.toml").to_dict() | {"units": UNITS})
    assert modes.units["frequency"] == "Hz"
    assert "left tip.x" not in modes.units
    assert modes.plot_shape(6, color="displacement").figure.axes[1].get_ylabel() == "relative displacement"
    assert modes.to_xarray(fields=["position"])["position"].attrs == {}
    plt.close("all")
