"""Studies in Python and by the program `ancf study`: same samples, same table."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
import pandas as pd
import pytest
import scipy.stats

import ancf

ANCF = "ANCF_PROGRAM"
"""Environment variable with the path of the program."""

Sampling = Literal["latin_hypercube", "random", "sobol"]
"""Sampling methods."""


def run_program(models: Path, file: Path, folder: Path) -> pd.DataFrame:
    """Run a study by the program that the environment variable names, else by the newest of the workspace."""
    own = [models.parent / "target" / profile / "ancf" for profile in ("release", "debug")]
    found = [Path(os.environ[ANCF])] if ANCF in os.environ else [path for path in own if path.exists()]
    if not found:
        pytest.skip(f"the program is not built, and {ANCF} does not contain its path")
    program = max(found, key=lambda path: path.stat().st_mtime)
    subprocess.run([program, "study", file, "-o", folder, "--quiet"], check=True, capture_output=True)
    return pd.read_parquet(folder / "cases.parquet")


@pytest.mark.parametrize("sampling", get_args(Sampling))
@pytest.mark.parametrize("seed", [0, 3, 2**32 - 1])
def test_a_seed_gives_the_samples_of_the_program(
    models: Path, tmp_path: Path, sampling: Sampling, seed: int
) -> None:
    file = tmp_path / "study.toml"
    file.write_text(
        f"""
        model = '{models / "cantilever.toml"}'
        samples = 9
        seed = {seed}
        sampling = "{sampling}"

        [parameters]
        elements = [1, 2]
        "materials.steel.young" = {{ kind = "normal", mean = 2e11, deviation = 1e10 }}
        "materials.steel.density" = {{ kind = "uniform", low = 7000, high = 8000 }}
        """
    )
    theirs = run_program(models, file, tmp_path)
    young, density = "materials.steel.young", "materials.steel.density"
    parameters = {
        "elements": [1, 2],
        young: scipy.stats.norm(2e11, 1e10),
        density: scipy.stats.uniform(7000, 1000),
    }
    model = models / "cantilever.toml"
    ours = ancf.study(model, parameters, samples=9, seed=seed, sampling=sampling).table
    assert list(ours.columns) == list(theirs.columns)
    assert list(ours["elements"]) == list(theirs["elements"]) == [1] * 9 + [2] * 9
    assert list(ours[density]) == list(theirs[density])
    # The quantiles of SciPy and of the program have different rounding errors.
    np.testing.assert_allclose(ours[young], theirs[young], rtol=1e-14)


def test_the_table_equals_the_table_of_the_program(models: Path, tmp_path: Path) -> None:
    theirs = run_program(models, models / "studies" / "convergence.toml", tmp_path)
    study = ancf.study(
        models / "cantilever.toml",
        {"elements": [1, 2, 4, 8, 16]},
        {"tip": ("tip.y", "mean")},
        folder=tmp_path,
    )
    ours = pd.read_parquet(tmp_path / "cases.parquet")
    assert list(ours.columns) == list(theirs.columns)
    assert list(ours.dtypes) == list(theirs.dtypes)
    same = ["case", "elements", "outcome", "message", "steps", "iterations"]
    pd.testing.assert_frame_equal(ours[same], theirs[same])
    np.testing.assert_allclose(ours["tip"], theirs["tip"], rtol=1e-12)
    assert len(study.finished) == 5


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ([True, False], "bool"),
        ([1, 2], "int64"),
        ([1, 0.5], "double"),
        ([1, 2**63], "double"),
        ([1, True], "string"),
        ([1, "a"], "string"),
        ([[1, 2]], "string"),
        ([{"a": None}, abs, None], "string"),
    ],
)
def test_types_of_columns(values: list[Any], expected: str) -> None:
    assert ancf._ancf.parameter_type(values) == expected
