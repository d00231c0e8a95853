"""Typed objects of models."""

from __future__ import annotations

import copy
import json
import os
import pickle
import re
import subprocess
import sys
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import ancf
import ancf.model
from ancf.model.base.part import Part

ROOT = Path(__file__).parents[4]
FILES = sorted([*ROOT.glob("models/*.toml"), *ROOT.glob("crates/ancf/tests/models/good/*.toml")])
#: Random models in which an equivalent model once had other results.
FOUND = sorted(ROOT.glob("crates/ancf-hunt/found/*_*.toml"))
#: Classes by their own names: a union of one class is an alias of it.
CLASSES: list[type[Part]] = [
    item
    for name in ancf.model.__all__
    if isinstance(item := ancf.model.__dict__.get(name), type)
    and issubclass(item, Part)
    and item.__name__ == name
]


def keys(part: type[Part]) -> list[str]:
    """The attributes of a class."""
    return [item.name for item in fields(part)]


def cantilever() -> ancf.Model:
    """The model of `models/cantilever.toml`."""
    beam = ancf.Beam(
        "beam",
        from_=(0.0, 0.0, 0.0),
        to=np.array([1.0, 0.0, 0.0]),
        elements=20,
        formulation="continuum",
        section="rod",
        material="steel",
    )
    return ancf.Model(
        title="Cantilever under its own weight",
        units=ancf.Units(length="m", time="s", force="N"),
        gravity=[0.0, -9.81, 0.0],
        materials={"steel": ancf.Material(density=8030.0, young=193e9, poisson=0.0)},
        sections={"rod": ancf.Circle(diameter=0.02)},
        bodies=[beam],
        joints=[ancf.Clamp("root", a=beam.start)],
        probes=[ancf.Probe("tip", on=beam.end)],
        analysis=ancf.Dynamics(
            duration=2.0, step=1e-3, scheme="adams", energy_guard=ancf.EnergyGuard(loss=1)
        ),
    )


def rod(**more: Any) -> ancf.Beam:
    """A beam with a section and a material instead of their names."""
    given: dict[str, Any] = {
        "section": ancf.Circle(diameter=0.02),
        "material": ancf.Material(density=1.0, young=1.0),
    }
    return ancf.Beam("rod", from_=[0, 0, 0], to=[1, 0, 0], elements=2, **given | more)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_file_is_written_unchanged(path: Path) -> None:
    """Objects read from a file have the data of the file. Omitted keys stay omitted."""
    from ancf import _ancf

    data = _ancf.read(path)
    model = ancf.Model.read(path)
    assert all(isinstance(part, Part) for part in [*model.bodies, *(model.joints or ()), model.analysis])
    assert model.to_dict() == data
    assert ancf.Model.from_dict(data) == model


def completed(model: ancf.Model | Path) -> ancf.Result:
    """Results of a run, up to its failure."""
    try:
        return ancf.run(model)
    except ancf.AnalysisError as error:
        assert error.result is not None
        return error.result


@pytest.mark.parametrize("path", FOUND, ids=lambda path: path.stem)
def test_a_random_model_has_equal_results_as_objects(path: Path, tmp_path: Path) -> None:
    """A model that is read as objects and written again has results with the same bits."""
    copy_of_it = tmp_path / "model.toml"
    ancf.Model.read(path).write(copy_of_it)
    first, second = completed(path), completed(ancf.Model.read(copy_of_it))
    assert first.columns == second.columns
    assert np.array_equal(first.data, second.data, equal_nan=True)


def test_a_typed_model_equals_its_file() -> None:
    """Objects and a file give the same model."""
    model = cantilever()
    assert model == ancf.Model.read(ROOT / "models/cantilever.toml")
    assert ancf.Model.from_dict(model.to_dict()) == model


def test_a_model_is_written_and_read(tmp_path: Path) -> None:
    """A written file is read as the same model."""
    path = tmp_path / "model.toml"
    cantilever().write(path)
    assert ancf.Model.read(path) == cantilever()


def test_errors_are_reported_when_a_part_is_built() -> None:
    """Values, words and lengths are checked with the messages of the command line, all at once."""
    with pytest.raises(ancf.ModelError, match=re.escape("diameter: found -1, expected a number > 0")):
        ancf.Circle(diameter=-1)
    given: dict[str, Any] = {"section": "s", "material": "m", "formulation": "linkd"}
    with pytest.raises(ancf.ModelError) as caught:
        ancf.Beam("", from_=[0, 0], to=np.zeros(3), elements=0, **given)
    assert sorted(str(caught.value).splitlines()) == [
        "Beam: elements: found 0, expected an integer >= 1",
        'Beam: formulation: found "linkd", expected "continuum", "enhanced", "linked" or "quadratic" '
        '(did you mean "linked"?)',
        "Beam: from: found an array of 2, expected an array of 3 numbers",
        'Beam: name: found "", expected a text that is not empty',
    ]


def test_unknown_and_missing_arguments_are_rejected() -> None:
    """As for any Python function."""
    with pytest.raises(TypeError, match="diametre"):
        ancf.Circle(diametre=1)  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="inner"):
        ancf.Tube(outer=1)  # type: ignore[call-arg]
    with pytest.raises(AttributeError, match="elemnts"):
        rod().elemnts = 3  # type: ignore[attr-defined]


def test_parts_of_another_class_are_rejected() -> None:
    """The message names the place of the part."""
    beam: Any = rod()
    with pytest.raises(
        TypeError, match=r"^Force: on: found a Beam, expected a Place; did you mean rod\.start"
    ):
        ancf.Force(on=beam, force=[1, 2, 3])
    with pytest.raises(TypeError, match="section: found a Material, expected a Circle, Tube, "):
        rod(section=ancf.Material(density=1, young=1))
    with pytest.raises(TypeError, match=re.escape("bodies[1]: found a Place, expected a Beam, ")):
        ancf.Model(bodies=[beam, beam.start], analysis=ancf.Modes())
    with pytest.raises(TypeError, match=r"sections\.x: found a Clamp"):
        sections: Any = {"x": ancf.Clamp("root", a=beam.start)}
        ancf.Model(bodies=[beam], sections=sections, analysis=ancf.Modes())


def test_data_of_another_class_are_rejected() -> None:
    """Plain data become the class with the same keys."""
    assert ancf.Circle.from_dict({"diameter": 1}) == ancf.Circle(diameter=1)
    with pytest.raises(ValueError, match="Circle"):
        ancf.Circle.from_dict({"kind": "tube", "outer": 2, "inner": 1})
    with pytest.raises(ancf.ModelError, match=re.escape("bodies[0].mass: found -1, expected a number > 0")):
        ancf.Model.from_dict(
            {
                "bodies": [{"kind": "mass", "name": "m", "mass": -1, "center": [0, 0, 0]}],
                "analysis": {"kind": "modes"},
            }
        )


def test_places_on_bodies() -> None:
    """A body makes its places, with or without an arm."""
    beam = rod()
    assert beam.start == ancf.Place("rod", "start")
    assert beam.end == ancf.Place("rod", "end")
    assert beam.at(0.25, offset=(0, 1, 0)) == ancf.Place("rod", 0.25, offset=[0, 1, 0])
    block = ancf.RigidBody("block", center=[0, 0, 0], mass=1, inertia=[1, 1, 1])
    assert block.at() == ancf.Place("block", "center")
    assert block.at([1, 2, 3]).to_dict() == {"body": "block", "at": [1, 2, 3]}
    assert ancf.Spring("s", a=beam.end, b=block.at(), stiffness=2.0).to_dict()["b"] == {
        "body": "block",
        "at": "center",
    }


def test_sections_and_materials_instead_of_names() -> None:
    """They are added to the tables of the model under unique names, equal ones once."""
    steel = ancf.Material("steel", density=2.0, young=2.0)
    bodies = [
        rod(),
        rod(section=ancf.Circle(diameter=0.02)),
        rod(
            section=ancf.Circle(diameter=0.03), section_end=ancf.Circle("thin", diameter=0.01), material=steel
        ),
        rod(section="strip", material="wood"),
    ]
    model = ancf.Model(
        bodies=bodies,
        sections={"strip": ancf.Rectangle(width=1, height=2)},
        materials={"wood": ancf.Material(density=1.0, young=1.0)},
        analysis=ancf.Modes(),
    )
    data = model.to_dict()
    assert data["sections"] == {
        "strip": {"kind": "rectangle", "width": 1, "height": 2},
        "circle": {"kind": "circle", "diameter": 0.02},
        "circle_2": {"kind": "circle", "diameter": 0.03},
        "thin": {"kind": "circle", "diameter": 0.01},
    }
    assert data["materials"] == {
        "wood": {"density": 1.0, "young": 1.0},
        "steel": {"density": 2.0, "young": 2.0},
    }
    assert [body["section"] for body in data["bodies"]] == ["circle", "circle", "circle_2", "strip"]
    assert [body["material"] for body in data["bodies"]] == ["wood", "wood", "steel", "wood"]
    assert data["bodies"][2]["section_end"] == "thin"
    assert model.sections is not None
    assert list(model.sections) == ["strip"], "the model itself is left as it was"
    layers = [ancf.Layer(material=steel), ancf.Layer(material="wood")]
    plate = ancf.FlatSurface(corner=[0, 0, 0], side_u=[1, 0, 0], side_v=[0, 1, 0])
    shell = ancf.Shell("s", surface=plate, elements=[2, 2], thickness=0.01, material="wood", layers=layers)
    data = ancf.Model(bodies=[shell], materials=model.materials, analysis=ancf.Modes()).to_dict()
    assert [layer["material"] for layer in data["bodies"][0]["layers"]] == ["steel", "wood"]
    assert list(data["materials"]) == ["wood", "steel"]


def test_functions_of_time() -> None:
    """A number, a class, or a callable, which is not converted."""
    place = rod().end
    times = [
        2.0,
        ancf.Ramp(end=1.0),
        ancf.TimeTable(times=np.arange(3), values=[0, 1, 0]),
        ancf.Expression("t^2"),
    ]
    data = [ancf.Force(on=place, force=[0, 0, 1], time=time).to_dict()["time"] for time in times]  # type: ignore[arg-type]
    assert data == [
        2.0,
        {"kind": "ramp", "end": 1.0},
        {"kind": "table", "times": [0, 1, 2], "values": [0, 1, 0]},
        {"kind": "expression", "text": "t^2"},
    ]
    assert ancf.Force(on=place, force=[0, 0, 1], time=abs).to_dict()["time"] is abs
    with_rates = ancf.LinearDrive(displacement=1.0, time=lambda t: (t, 1.0, 0.0))
    assert callable(with_rates.to_dict()["time"])


def test_parts_are_mutable_and_found_by_name() -> None:
    """Attributes may be set. An error for an unknown name lists the known ones."""
    model = cantilever()
    model.body("beam").elements = 40
    assert model.to_dict()["bodies"][0]["elements"] == 40
    assert model != cantilever()
    assert model.joint("root").a.at == "start"
    assert model.probe("tip").on == model.body("beam").end
    with pytest.raises(KeyError, match="beam"):
        model.body("baem")
    with pytest.raises(KeyError, match="no joint"):
        ancf.Model(bodies=[rod()], analysis=ancf.Modes()).joint("root")
    bob = {"kind": "mass", "name": "bob", "center": [0, 0, 0], "mass": 1}
    assert ancf.Model(bodies=[bob], analysis=ancf.Modes()).body("bob") is bob  # type: ignore[list-item]


def test_equality_compares_values() -> None:
    """Lists, tuples and arrays of the same numbers are equal, different sections are not."""
    assert ancf.Ground(point=[1, 2, 3]) == ancf.Ground(point=np.array([1.0, 2.0, 3.0]))
    assert ancf.Ground(point=[1, 2, 3]) != ancf.Ground(point=(1, 2, 4))
    assert rod() == rod()
    assert rod() != rod(section=ancf.Circle(diameter=0.03))
    assert rod() != rod(twist=0.0)
    assert ancf.Circle("a", diameter=1) != ancf.Circle("b", diameter=1)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_models_are_copied_and_pickled(path: Path) -> None:
    """Studies send models to other processes."""
    model = ancf.Model.read(path)
    assert pickle.loads(pickle.dumps(model)) == model
    twin = copy.deepcopy(model)
    assert twin == model
    twin.title = "another"
    assert twin != model


def test_the_representation_is_valid_code() -> None:
    """Omitted keys are not printed. Only the whole model has a summary instead."""
    assert repr(ancf.Circle(diameter=1)) == "Circle(diameter=1)"
    model = cantilever()
    names = {name: getattr(ancf, name) for name in ancf.model.__all__}
    parts: list[Any] = [rod(), *(model.joints or ()), *(model.probes or ()), model.analysis, model.units]
    for part in parts:
        assert eval(repr(part), names) == part


def test_every_form_of_the_schema_has_a_class() -> None:
    """Every table has a class and every key a documented attribute."""
    schema = json.loads((ROOT / "docs/model.schema.json").read_text("utf-8"))
    tables = [schema]
    # Lists of analyses belong to model files.
    schema["$defs"].pop("SequenceAnalysis")
    for definition in schema["$defs"].values():
        tables += [
            form
            for form in definition.get("oneOf", definition.get("anyOf", [definition]))
            if "properties" in form
        ]
    expected = sorted(
        sorted(key for key, of in table["properties"].items() if "x-sequence" not in of) for table in tables
    )
    found = []
    for part in CLASSES:
        tag = [part._tag] if part._tag else []
        names = [name for name in keys(part) if name not in part._own]
        found.append(sorted([name.rstrip("_") for name in names] + tag))
    assert sorted(found) == expected


@pytest.mark.parametrize("part", CLASSES, ids=lambda part: part.__name__)
def test_every_attribute_is_documented(part: type[Part]) -> None:
    """The docstring describes a class and each of its attributes."""
    text = part.__doc__ or ""
    assert text.splitlines()[0].endswith((".", "?"))
    for name in keys(part):
        assert re.search(rf"^    {name}\n        \S", text, re.MULTILINE), name


RIGHT = """
from matplotlib.axes import Axes
import numpy as np

one: Axes = result.plot("tip.y", "tip.x", linestyle="--")
for ax in result.plot("tip.y", "tip.x", subplots=True).flat:
    ax.set_title("a title")
many = result.plot().shape
values = {"elements": [1, 2]}
ancf.study(model, values, "tip.y")
ancf.study(model, values, ("tip.y", "mean"))
ancf.study(model, values, {"a": "tip.y", "b": ("tip.y", 3), "c": lambda r: r["tip.y"].mean()})
ancf.study(model, values, lambda r: r["tip.y"][-1])
ancf.study(model, values, lambda r: {"a": np.mean(r["tip.y"]), "b": float(r.time[-1])})


def tip(result: ancf.Result) -> dict[str, float]:
    return {"tip": float(result["tip.y"][-1])}


def end(result: ancf.Result) -> float:
    return float(result["tip.y"][-1])


ancf.study(model, values, tip)
ancf.study(model, values, {"end": end, "last": "tip.y"})
"""


def checked(path: Path) -> str:
    """Return the output of a type checker for a file."""
    pytest.importorskip("mypy")
    command = [sys.executable, "-m", "mypy", "--strict", "--config-file=", "--hide-error-context", str(path)]
    package = Path(ancf.__file__).parents[1]
    # An installed package is found without this path and must not be on it.
    there = {"MYPYPATH": str(package)} if package.name == "python" else {}
    return subprocess.run(
        command, capture_output=True, text=True, check=False, env={**os.environ, **there}
    ).stdout


def test_a_type_checker_finds_mistakes() -> None:
    """Exactly the lines marked as wrong are found."""
    path = Path(__file__).with_name("typed_wrong.py")
    output = checked(path)
    found = {int(line) for line in re.findall(r"typed_wrong\.py:(\d+): error", output)}
    lines = path.read_text("utf-8").splitlines()
    assert found == {number for number, line in enumerate(lines, 1) if line.endswith("# wrong")}, output


def test_a_type_checker_accepts_valid_programs(tmp_path: Path) -> None:
    """The first program of the README, and all forms of plots and objectives."""
    page = Path(__file__).parents[4] / "README.md"
    block = re.search(r"```python\n(.*?)```", page.read_text("utf-8"), re.DOTALL)
    assert block is not None
    path = tmp_path / "start.py"
    path.write_text(block[1] + RIGHT, encoding="utf-8")
    assert not re.findall(r"start\.py:\d+: error.*", checked(path))
