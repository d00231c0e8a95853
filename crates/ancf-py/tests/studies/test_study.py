"""Studies: cases, objectives, samples, restart and errors."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import scipy.stats

import ancf


class Log:
    """Counts the calls of an objective in a file, which leaves its description unchanged."""

    def __init__(self, folder: Path) -> None:
        """Start at zero."""
        self._file = str(folder / "calls.log")

    def tip(self, result: ancf.Result) -> float:
        """The deflection at the end."""
        with Path(self._file).open("a") as file:
            file.write(".")
        return float(result["tip.y"][-1])

    @property
    def calls(self) -> int:
        """Number of calls."""
        return Path(self._file).stat().st_size if Path(self._file).exists() else 0


def test_a_sweep_equals_single_runs(bar: dict[str, Any]) -> None:
    study = ancf.study(bar, {"elements": [1, 3], "gravity[1]": [-9.81, -1.62]}, {"tip": "tip.y"})
    assert list(study.table["elements"]) == [1, 1, 3, 3]
    assert list(study.table["gravity[1]"]) == [-9.81, -1.62] * 2
    for _, row in study.table.iterrows():
        single = bar | {"gravity": [0, row["gravity[1]"], 0]}
        single["bodies"] = [bar["bodies"][0] | {"elements": row["elements"]}]
        result = ancf.run(single)
        assert row["tip"] == result["tip.y"][-1]
        assert row["iterations"] == result.summary["iterations"]
    assert set(study.table["outcome"]) == {"finished"}
    assert study.table["key"].is_unique


def test_lists_in_pairs_each_with_every_sample(bar: dict[str, Any]) -> None:
    parameters = {
        "elements": [1, 2],
        "bodies.beam.formulation": ["continuum", "enhanced"],
        "bodies.beam.material.young": scipy.stats.uniform(190e9, 10e9),
    }
    study = ancf.study(bar, parameters, {"tip": "tip.y"}, combine="zip", samples=3)
    table = study.table
    assert list(table["elements"]) == [1, 1, 1, 2, 2, 2]
    assert list(table["bodies.beam.formulation"]) == ["continuum"] * 3 + ["enhanced"] * 3
    young = table["bodies.beam.material.young"]
    assert list(young[:3]) == list(young[3:])
    assert young.between(190e9, 200e9).all()
    assert len(ancf.study(bar, parameters, {"tip": "tip.y"}, samples=3)) == 12


def test_values_of_any_kind(bar: dict[str, Any], tmp_path: Path) -> None:
    vectors = np.array([[0, -9.81, 0], [0, 0, -9.81]])
    steels = [ancf.Material(density=7850.0, young=young) for young in (2e11, 2.1e11)]
    study = ancf.study(bar, {"gravity": vectors, "materials.steel": steels}, folder=tmp_path)
    assert len(study.finished) == 4
    assert list(study.table["gravity"][::2]) == ["[0.0, -9.81, 0.0]", "[0.0, 0.0, -9.81]"]
    pd.testing.assert_frame_equal(pd.read_parquet(tmp_path / "cases.parquet"), study.table)


def test_objectives_of_every_kind(rod: dict[str, Any]) -> None:
    result = ancf.run(rod)
    y = result["tip.y"]
    takes = {"first": y[0], "last": y[-1], "mean": y.mean(), "min": y.min(), "max": y.max()}
    takes |= {"amplitude": np.ptp(y) / 2, "rms": np.sqrt((y**2).mean())}
    objective = {take: ("tip.y", take) for take in takes} | {"row": ("tip.y", 7), "plain": "tip.y"}
    table = ancf.study(rod, {"elements": [4]}, objective).table  # type: ignore[arg-type]
    for take, value in takes.items():
        assert table[take][0] == pytest.approx(value, rel=1e-14)
    assert (table["row"][0], table["plain"][0]) == (y[7], y[-1])
    deepest = float(result.field("position")[:, :, 1].min())
    several = ancf.study(
        rod, {"elements": [4]}, lambda r: {"deepest": r.field("position")[..., 1].min(), "end": r.time[-1]}
    )
    assert several.objectives == ["deepest", "end"]
    assert several.table["deepest"][0] == deepest
    # Without a row of that number the case is finished and its number is missing.
    short = ancf.study(rod, {"elements": [4]}, {"late": ("tip.y", 1000)}).table
    assert np.isnan(short["late"][0])
    assert short["message"][0] == "objectives.late: no row 1000 among 301"


def test_rows_of_earlier_runs_are_reused(bar: dict[str, Any], tmp_path: Path) -> None:
    log = Log(tmp_path)

    def run(elements: list[int], model: dict[str, Any] = bar) -> ancf.Study:
        return ancf.study(model, {"elements": elements}, log.tip, folder=tmp_path)

    first = run([1, 2, 3])
    assert log.calls == 3
    pd.testing.assert_frame_equal(run([1, 2, 3]).table, first.table)
    assert log.calls == 3
    more = run([1, 2, 4, 3])
    assert log.calls == 4
    assert list(more.table["elements"]) == [1, 2, 4, 3]
    assert list(more.table["tip"].iloc[[0, 1, 3]]) == list(first.table["tip"])
    # The title has no effect, gravity has. Another objective of the same name is another number.
    run([1, 2, 4], bar | {"title": "the same"})
    assert log.calls == 4
    run([1, 2], bar | {"gravity": [0, -1.62, 0]})
    assert log.calls == 6
    other = ancf.study(bar, {"elements": [1, 2]}, {"tip": "tip.x"}, folder=tmp_path)
    assert (other.table["tip"] > 0.9).all()


def test_different_functions_have_different_keys(rod: dict[str, Any], tmp_path: Path) -> None:
    def pull(size: float) -> Any:
        return lambda t: size * t

    load = {"kind": "force", "on": {"body": "arm", "at": "end"}, "force": [0, 1, 0], "time": pull(1.0)}
    model = rod | {"loads": [load]}

    def tips(*sizes: float) -> list[float]:
        parameters = {"loads[0].time": [pull(size) for size in sizes]}
        return list(ancf.study(model, parameters, {"tip": "tip.y"}, folder=tmp_path).table["tip"])

    one, two = tips(1.0, 20.0)
    assert one < two
    assert tips(20.0, 1.0) == [two, one]


def test_failures_are_rows(bar: dict[str, Any], tmp_path: Path) -> None:
    def tip(result: ancf.Result) -> float:
        if result["tip.y"][-1] < -0.01:
            raise ArithmeticError("too deep")
        return float(result["tip.y"][-1])

    loads = [{"kind": "force", "on": {"body": "beam", "at": "end"}, "force": [0, 0, 0]}]
    model = bar | {"loads": loads, "analysis": {"kind": "statics", "max_iterations": 12}}
    forces = [[0, 0, 0], [0, -100, 0], [-1e9, 1e3, 0], [0, 0]]
    study = ancf.study(model, {"loads[0].force": forces}, tip, folder=tmp_path)
    assert list(study.table["outcome"]) == ["finished", "failed", "failed", "invalid"]
    messages = list(study.table["message"])
    assert messages[1] == "objectives.tip: ArithmeticError: too deep"
    assert "load" in messages[2]
    with pytest.raises(ancf.ModelError) as caught:
        ancf.run(model | {"loads": [loads[0] | {"force": [0, 0]}]})
    assert messages[3] == str(caught.value)
    assert np.isnan(study.table["tip"][1:]).all()
    assert (len(study.finished), len(study.failed)) == (1, 3)
    # They are reused unless `retry` is set.
    seconds = study.table["seconds"]
    kept = ancf.study(model, {"loads[0].force": forces}, tip, folder=tmp_path).table["seconds"]
    assert list(kept == seconds) == [True] * 4
    tried = ancf.study(model, {"loads[0].force": forces}, tip, folder=tmp_path, retry=True).table["seconds"]
    assert list(tried == seconds) == [True, False, False, False]


def test_all_errors_are_reported_before_a_case_runs(bar: dict[str, Any], tmp_path: Path) -> None:
    law = scipy.stats.norm(193e9, 5e9)
    parameters = {
        "elemnts": [1],
        "elements": [],
        "gravity": 9.81,
        "bodies.beam.material.young": law,
        "title": "a",
    }
    objective: Any = {"tip": "tip.q", "case": "tip.y", "a": ("tip.y", "men"), "b": 3}
    with pytest.raises(ancf.ModelError) as caught:
        ancf.study(bar, parameters, objective, combine="gird", folder=tmp_path / "new")  # type: ignore[arg-type]
    assert str(caught.value).splitlines() == [
        'combine: found "gird", expected "grid" or "zip" (did you mean "grid"?)',
        "parameters.elements: found an empty list, expected a list of at least one value",
        "parameters.gravity: found 9.81, expected a list of values, or a distribution such as "
        "scipy.stats.norm(mean, deviation)",
        'parameters.title: found "a", expected a list of values, or a distribution such as '
        "scipy.stats.norm(mean, deviation)",
        'parameters."bodies.beam.material.young": found a distribution without `samples`, expected the number of '
        "samples, such as `samples=100`",
        "parameters.elemnts: found unknown key `elemnts`, expected a key of the model or of a body "
        "(did you mean `elements`?)",
        "objectives.case: found `case`, which is another column of the table, expected another name",
        'objectives.a: found "men", expected "first", "last", "mean", "min", "max", "amplitude", "rms" or '
        'a row from 0 (did you mean "mean"?)',
        "objectives.b: found 3, expected a function of the result, or a column and what is taken of it, such as "
        '("tip.y", "mean")',
        'objectives.tip: found "tip.q", which is no column of the results, expected a column of the results of the '
        'model (did you mean "tip.z"?)',
    ]
    assert not (tmp_path / "new").exists()


def test_a_value_that_is_no_data_is_an_invalid_row(bar: dict[str, Any]) -> None:
    table = ancf.study(bar, {"gravity": [[0.0, -9.81, 0.0], {1.0}]}).table
    assert list(table["outcome"]) == ["finished", "invalid"]
    assert list(table["gravity"]) == ["[0.0, -9.81, 0.0]", '"{1.0}"']


def test_numbers_of_cases_and_samples_are_limited(bar: dict[str, Any]) -> None:
    law = {f"gravity[{k}]": scipy.stats.norm() for k in range(482)}
    (line,) = [line for line in errors_of(bar, law, samples=2, sampling="sobol") if "Sobol" in line]
    assert line == "parameters: found 482 distributions, expected at most 481 in a Sobol sequence"
    assert errors_of(bar, {"gravity[1]": law["gravity[1]"]}, samples=10**20, seed=2**32) == [
        "seed: found 4294967296, expected an integer from 0 to 4294967295",
        "samples: found 100000000000000000000, expected an integer from 1 to 10000000",
    ]


def test_places_are_set_once_and_pairs_are_pairs(bar: dict[str, Any]) -> None:
    parameters: dict[str, Any] = {"bodies.beam.elements": [1, 2], "elements": [1, 2, 3]}
    with pytest.raises(ancf.ModelError) as caught:
        ancf.study(bar, parameters, combine="zip")
    assert str(caught.value).splitlines() == [
        "parameters.elements: found 3 values, expected 2, as many as `bodies.beam.elements` has, since `combine` is "
        '"zip"',
        "parameters.elements: found `bodies[0].elements`, which `bodies.beam.elements` sets too, expected every place "
        "to be set once",
    ]
    # The alphabetical order in which parameters are set has no effect.
    parameters = {
        "bodies.beam.material.young": [193e9, 100e9],
        "materials.steel": [{"density": 8030, "young": 193e9}],
        "bodies.beam.section": [bar["bodies"][0]["section"]],
        "section.diameter": [0.02, 0.03],
        "gravity": [[0, -1, 0]],
        "gravity[1]": [-2],
    }
    with pytest.raises(ancf.ModelError) as caught:
        ancf.study(bar, parameters)
    whole = "expected every place to be set once (give the whole with its parts, or the parts alone)"
    assert str(caught.value).splitlines() == [
        f'parameters."gravity[1]": found `gravity[1]`, which `gravity` sets too, {whole}',
        'parameters."materials.steel": found `materials.steel`, of which `bodies.beam.material.young` sets a part, '
        f"{whole}",
        'parameters."section.diameter": found a path through what `bodies.beam.section` sets, expected a path that '
        f"leads to the same place in every case (such as `sections.{bar['bodies'][0]['section']}.diameter`)",
    ]
    with pytest.raises(ancf.ModelError, match="expected at most 10 000 000 cases"):
        ancf.study(bar, {"elements": range(1, 10001), "gravity[1]": range(10001)})
    with pytest.raises(ancf.ModelError, match=r"found a distribution with the quantile nan"):
        ancf.study(bar, {"gravity[1]": scipy.stats.norm(1, -1)}, samples=2)


def test_columns_are_those_of_the_first_case(bar: dict[str, Any]) -> None:
    parameters = {"probes": [[{"name": "end", "on": {"body": "beam", "at": "end"}}]]}
    study = ancf.study(bar, parameters, {"end": "end.y"})
    assert len(study.finished) == 1
    with pytest.raises(ancf.ModelError, match=r"found \"tip.y\", which is no column of the results"):
        ancf.study(bar, parameters, {"tip": "tip.y"})


def test_an_interrupt_keeps_what_is_done(rod: dict[str, Any], tmp_path: Path) -> None:
    log = Log(tmp_path)

    def tip(result: ancf.Result) -> float:
        if result.time[-1] > 0.25:
            # A busy machine may delay the third case.
            end = time.perf_counter() + 20
            while log.calls < 3 and time.perf_counter() < end:
                time.sleep(0.01)
            time.sleep(0.2)
            os.kill(os.getpid(), signal.SIGINT)
        return log.tip(result)

    # Three cases are done when the fourth ends; then there are two motions that would take hours.
    durations = [0.01, 0.02, 0.03, 0.3, 1e5, 2e5, 0.05]
    clock = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        ancf.study(rod, {"analysis.duration": durations}, tip, folder=tmp_path, jobs=2, states="none")
    assert time.perf_counter() - clock < 30
    table = pd.read_parquet(tmp_path / "cases.parquet").set_index("case")
    assert list(table["outcome"][:4]) == ["finished"] * 4
    assert set(table["outcome"][4:]) <= {"stopped"}
    assert 6 not in table.index
    short = [*durations[:4], 0.05]
    study = ancf.study(rod, {"analysis.duration": short}, tip, folder=tmp_path, states="none")
    assert len(study.finished) == 5
    assert log.calls == 5


def errors_of(bar: dict[str, Any], parameters: Any, objective: Any = None, **settings: Any) -> list[str]:
    """Return the errors of a study before a case runs."""
    with pytest.raises(ancf.ModelError) as caught:
        ancf.study(bar, parameters, objective, **settings)
    return str(caught.value).splitlines()


def test_settings_are_checked(bar: dict[str, Any], tmp_path: Path) -> None:
    def never(_: ancf.Result) -> float:
        raise AssertionError("a case was run")

    expected = "expected an integer >= 1, or -1 for all cores"
    for jobs in [0, -2, 1.5, True, "two"]:
        shown = f'"{jobs}"' if isinstance(jobs, str) else jobs
        assert errors_of(bar, {"elements": [1]}, never, jobs=jobs) == [f"jobs: found {shown}, {expected}"]
    assert errors_of(bar, {"elements": [1]}, never, states="al", client=3, seed="x", folder=5) == [
        "folder: found 5, expected a path",
        'states: found "al", expected "all", "positions" or "none" (did you mean "all"?)',
        "client: found 3, expected a client of dask.distributed",
        'seed: found "x", expected an integer from 0 to 4294967295',
    ]
    law = {"gravity[1]": scipy.stats.norm(-9, 1)}
    for samples in [0, 2.0, "many", True]:
        (line,) = errors_of(bar, law, never, samples=samples)
        assert line.startswith("samples: found") and line.endswith("expected an integer from 1 to 10000000")
    assert errors_of(bar, ["elements"], never) == ["parameters: found ['elements'], expected a dictionary"]
    assert errors_of(bar, {3: [1]}, {4: never}) == [
        "parameters: found the name 3, expected texts as names",
        "objectives: found the name 4, expected texts as names",
    ]
    file = tmp_path / "file"
    file.touch()
    (line,) = errors_of(bar, {"elements": [1]}, never, folder=file)
    assert line.startswith(f'folder: found "{file}", where no file can be written (')
    assert line.endswith("expected a folder to write to")
    study = ancf.study(
        bar, law, {"tip": ("tip.y", np.int64(0))}, samples=np.int64(2), seed=np.int64(1), jobs=-1
    )
    assert len(study.finished) == 2


def test_kept_states_belong_to_the_key(bar: dict[str, Any], tmp_path: Path) -> None:
    def kept(result: ancf.Result) -> float:
        return float(result.field("velocity")[-1, -1, 0])

    def outcome(states: Any) -> str:
        study = ancf.study(bar, {"elements": [1]}, kept, folder=tmp_path, states=states)
        return str(study.table["outcome"][0])

    assert [outcome("none"), outcome("all"), outcome("none")] == ["failed", "finished", "failed"]


def test_an_objective_without_number_is_a_failed_row(bar: dict[str, Any]) -> None:
    def message(objective: Any) -> str:
        (row,) = ancf.study(bar, {"elements": [1]}, objective).failed["message"]
        return str(row)

    assert message(lambda r: {}) == (
        "objectives.objective: found {}, expected at least one number, by names that are texts"
    )
    assert message({"a": lambda r: {"b": 1.0}}) == (
        "objectives.a: found {'b': 1.0}, expected a number, since this objective is one of several by name"
    )
    assert message(lambda r: {"a": {"b": 1}}) == (
        "objectives.objective: found {'b': 1}, expected a number as 'a'"
    )
    assert message(lambda r: None) == (
        "objectives.objective: found None, expected a number or several by name"
    )


def test_a_column_alone_is_an_objective(bar: dict[str, Any]) -> None:
    last = ancf.study(bar, {"elements": [2]}, "tip.y").table["objective"][0]
    assert ancf.study(bar, {"elements": [2]}, ("tip.y", "last")).table["objective"][0] == last


def test_warnings_of_cases_are_one_warning() -> None:
    """A column above its critical load, 63.6 N: the case finishes with a warning in its row."""
    model = {
        "materials": {"steel": {"density": 7850, "young": 2.1e11}},
        "sections": {"round": {"kind": "circle", "diameter": 0.01}},
        "bodies": [
            {
                "kind": "beam",
                "name": "arm",
                "from": [0, 0, 0],
                "to": [0, 0, 2],
                "elements": 4,
                "section": "round",
                "material": "steel",
            }
        ],
        "joints": [{"kind": "clamp", "name": "root", "a": {"body": "arm", "at": "start"}}],
        "loads": [{"kind": "force", "on": {"body": "arm", "at": "end"}, "force": [0, 0, -100]}],
        "probes": [{"name": "tip", "on": {"body": "arm", "at": "end"}}],
        "analysis": {"kind": "statics"},
    }
    with pytest.warns(ancf.AnalysisWarning, match="cases with warnings .column `message`.: 1; case 1: "):
        study = ancf.study(model, {"loads[0].force[2]": [-10, -100]}, {"tip": ("tip.z", "last")})
    assert list(study.table["outcome"]) == ["finished", "finished"]
    assert list(study.warned["case"]) == [1]
    assert "lost its stability" in study.warned["message"].iloc[0]
