"""Models with several analyses."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ancf
from ancf import _ancf

ROPE: dict[str, Any] = {
    "gravity": [0, 0, -9.81],
    "materials": {"steel": {"density": 7850, "young": 2.1e11}},
    "sections": {"wire": {"kind": "circle", "diameter": 0.005}},
    "bodies": [
        {
            "kind": "cable",
            "name": "rope",
            "from": [0, 0, 0],
            "to": [1, 0, 0],
            "elements": 8,
            "section": "wire",
            "material": "steel",
        }
    ],
    "joints": [
        {"kind": "spherical", "name": "left", "a": {"body": "rope", "at": "start"}},
        {
            "kind": "spherical",
            "name": "right",
            "a": {"body": "rope", "at": "end"},
            "not_in": ["release", "swing"],
        },
    ],
    "probes": [{"name": "tip", "on": {"body": "rope", "at": "end"}}],
    "analysis": [
        {"kind": "statics", "name": "hang"},
        {"kind": "modes", "name": "tones", "about": "equilibrium", "count": 2},
        {"kind": "dynamics", "name": "release", "duration": 0.1, "step": 1e-3},
        {"kind": "dynamics", "name": "swing", "duration": 0.1, "step": 1e-3, "set": {"gravity": [0, 0, -5]}},
    ],
}


def test_analyses_start_in_the_last_state_before_them() -> None:
    results = ancf.run_sequence(ROPE)
    assert list(results) == ["hang", "tones", "release", "swing"]
    hang, release, swing = (results[name] for name in ("hang", "release", "swing"))
    assert results["tones"].kind == "modes"
    assert np.allclose(release["tip.z"][0], hang["tip.z"][-1], atol=1e-12)
    for column in ("tip.x", "tip.z", "tip.vx", "tip.vz"):
        assert swing[column][0] == pytest.approx(release[column][-1], abs=1e-9), column
    assert release["t"][0] == 0.0
    assert swing["t"][0] == pytest.approx(0.1)
    assert swing["t"][-1] == pytest.approx(0.2)


def test_results_are_those_of_the_program(tmp_path: Path, program: Path) -> None:
    file = tmp_path / "rope.toml"
    file.write_text(_ancf.to_toml(ROPE))
    subprocess.run([str(program), "run", str(file), "-o", str(tmp_path / "out"), "--quiet"], check=True)
    for number, (name, result) in enumerate(ancf.run_sequence(file).items()):
        stored = ancf.load(tmp_path / "out" / f"{number + 1}-{name}")
        assert stored.columns == result.columns
        assert np.allclose(stored.data[-1], result.data[-1], rtol=1e-9, atol=1e-9)


def test_a_failure_keeps_the_results_before_it() -> None:
    hang, tones, release, swing = ROPE["analysis"]
    hurried = release | {"step": 0.05, "max_iterations": 1, "max_halvings": 0}
    wrong = ROPE | {"analysis": [hang, tones, hurried, swing]}
    with pytest.raises(ancf.AnalysisError) as failed:
        ancf.run_sequence(wrong)
    assert list(failed.value.completed) == ["hang", "tones"]
    assert failed.value.result is not None


def test_errors_have_paths_of_the_data() -> None:
    wrong = ROPE | {"analysis": [{"kind": "statics", "name": "hang"}, {"kind": "dynamics", "duration": -1}]}
    with pytest.raises(ancf.ModelError) as found:
        ancf.run_sequence(wrong)
    assert all(error.place is None for error in found.value.errors)
    assert any(error.path.startswith("analysis[1].duration") for error in found.value.errors)
    with pytest.raises(ancf.ModelError, match=r"ancf\.run_sequence"):
        ancf.run(ROPE)


def test_single_analyses_are_lists_of_one(rod: dict[str, Any]) -> None:
    (result,) = ancf.run_sequence(rod).values()
    assert np.array_equal(result.data, ancf.run(rod).data)


def test_checks_describe_each_analysis() -> None:
    text = ancf.check(ROPE)
    assert "analysis `hang`" in text
    assert "analysis `swing`" in text
    assert text.count("degrees of freedom") == 4


def test_turns_continue() -> None:
    """A hinge that turns freely counts its turns through all analyses, from a result and from a folder."""
    rotor: dict[str, Any] = {
        "bodies": [
            {
                "kind": "rigid",
                "name": "rotor",
                "center": [0, 0, 0],
                "mass": 1,
                "inertia": [1, 1, 1],
                "motion": {"spin": [0, 0, 10]},
            }
        ],
        "joints": [
            {"kind": "revolute", "name": "h", "a": {"body": "rotor", "at": "center"}, "axis": [0, 0, 1]}
        ],
        "analysis": [
            {"kind": "dynamics", "name": "a", "duration": 1, "step": 0.01},
            {"kind": "dynamics", "name": "b", "duration": 1, "step": 0.01},
        ],
    }
    first, second = ancf.run_sequence(rotor).values()
    assert abs(first["h.angle"][-1] - 10) < 0.02
    assert second["h.angle"][0] == pytest.approx(first["h.angle"][-1], abs=1e-9)
    assert abs(second["h.angle"][-1] - 20) < 0.04
