"""Representations of all objects as text and as HTML."""

from __future__ import annotations

import inspect
import types
from functools import cache
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest

import ancf
from ancf.display.numbers import quantity_text
from ancf.display.tables import Table, joined


@cache
def model() -> ancf.Model:
    """A model with parts of several classes. Names have characters with a meaning in HTML."""
    steel = ancf.Material("steel", density=7850.0, young=2.1e11)
    arm = ancf.Beam(
        "arm <1> & co",
        from_=[0, 0, 0],
        to=[1, 0, 0],
        elements=2,
        section=ancf.Circle(diameter=0.02),
        material=steel,
    )
    block = ancf.RigidBody("block", center=[2, 0, 0], mass=1, inertia=[1, 1, 1])
    return ancf.Model(
        title="<script>alert(1)</script> & more",
        units=ancf.Units(length="m", time="s", force="N"),
        gravity=np.array([0, 0, -9.81]),
        bodies=[arm, block],
        joints=[
            ancf.Revolute("hinge", a=arm.start, axis=[0, 1, 0]),
            ancf.Spring("rope", a=arm.end, b=block.at(), stiffness=10.0),
        ],
        loads=[ancf.Force(on=arm.end, force=[0, 0, 1], time=lambda t: t)],
        probes=[ancf.Probe("tip", on=arm.end)],
        analysis=ancf.Dynamics(duration=0.01, step=1e-3),
    )


@cache
def result() -> ancf.Result:
    """The result of the model."""
    return ancf.run(model())


@cache
def study() -> ancf.Study:
    """Two finished cases and an invalid one."""
    return ancf.study(model(), {"bodies.block.mass": [1.0, 2.0, -1.0]}, {"last <x>": "tip.x"})


def reached(start: Any) -> dict[int, Any]:
    """Return all objects of the package that are reached by public attributes, items and properties."""
    found: dict[int, Any] = {}
    waiting = [start]
    while waiting:
        thing = waiting.pop()
        if id(thing) in found or not type(thing).__module__.startswith(("ancf", "builtins")):
            continue
        found[id(thing)] = thing
        if isinstance(thing, dict | types.MappingProxyType) or hasattr(thing, "items"):
            waiting += list(thing.values())
        elif isinstance(thing, list | tuple):
            waiting += list(thing)
        elif type(thing).__module__.startswith("ancf"):
            for name in dir(thing):
                if not name.startswith("_") and not inspect.ismethod(
                    inspect.getattr_static(thing, name, None)
                ):
                    try:
                        waiting.append(getattr(thing, name))
                    except (AttributeError, KeyError):
                        continue
    return {key: thing for key, thing in found.items() if not inspect.isroutine(thing)}


class Texts(HTMLParser):
    """Reads tags and texts, and checks that all tags are closed."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: set[str] = set()
        self.texts: list[str] = []

    def handle_starttag(self, tag: str, attrs: object) -> None:  # noqa: D102
        self.open.append(tag)
        self.tags.add(tag)

    def handle_endtag(self, tag: str) -> None:  # noqa: D102
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:  # noqa: D102
        self.texts.append(data)


def read(html: str) -> Texts:
    """Read HTML that must be complete."""
    parser = Texts()
    parser.feed(html)
    assert not parser.open
    return parser


def instant() -> ancf.Instant:
    """One row of a run."""
    seen: list[ancf.Instant] = []
    ancf.run(model(), callback=lambda now: seen.append(now))
    return seen[-1]


@pytest.mark.parametrize("start", [model, result, study, instant], ids=lambda start: start.__name__)
def test_every_object_has_a_representation(start: Any) -> None:
    things = reached(start())
    classes = {type(thing).__name__ for thing in things.values()}
    expected = {
        "model": {"Model", "Beam", "Place", "Dynamics"},
        "result": {"Result", "Energy", "Reaction", "JointMotion", "Probe", "States"},
        "study": {"Study"},
        "instant": {"Instant", "Energy", "Probe"},
    }
    assert expected[start.__name__] <= classes
    for thing in things.values():
        text = repr(thing)
        assert "object at 0x" not in text, type(thing)
        if hasattr(type(thing), "_repr_html_"):
            page = read(thing._repr_html_())
            assert "script" not in page.tags
            assert len(thing._repr_html_()) < 20_000


def test_a_model_is_summarised_in_a_few_lines() -> None:
    assert repr(model()).splitlines() == [
        'Model "<script>alert(1)</script> & more"',
        "  units     m, s, N",
        "  gravity   [0.0, 0.0, -9.81]",
        "  bodies    1 Beam, 1 RigidBody: arm <1> & co, block",
        "  joints    1 Revolute, 1 Spring: hinge, rope",
        "  loads     1 Force",
        "  probes    1 Probe: tip",
        "  analysis  Dynamics(duration=0.01, step=0.001)",
    ]
    page = read(model()._repr_html_())
    assert {"arm <1> & co", "block", "RigidBody", "bodies (2)", "joints (2)"} <= set(page.texts)
    many = ancf.Model(
        bodies=[ancf.PointMass(f"mass{i}", center=[i, 0, 0], mass=1) for i in range(100)],
        analysis=ancf.Modes(),
    )
    assert max(map(len, repr(many).splitlines())) < 100
    assert "100 PointMass: mass0, mass1, " in repr(many)
    assert "..., mass99" in repr(many)


def test_views_are_tables_of_their_columns() -> None:
    run = result()
    lines = repr(run.energy).splitlines()
    assert lines[0] == f"Energy, {len(run)} rows"
    assert lines[1].split() == ["unit", "first", "last", "minimum", "maximum"]
    assert lines[2].split()[:2] == ["kinetic", "J"]
    assert float(lines[2].split()[3]) == pytest.approx(run.energy.kinetic[-1], rel=1e-3)
    hinge = repr(run.reactions["hinge"]).splitlines()
    assert [line.split()[:2] for line in hinge[2:]] == [
        *(["f" + axis, "N"] for axis in "xyz"),
        *(["m" + axis, "N"] for axis in "xyz"),
    ]
    assert "angle" in repr(run.joints["hinge"])
    page = read(run._repr_html_())
    assert {"dynamics, finished", "hinge, rope", "tip", "kinetic", "J"} <= set(page.texts)


def test_a_study_shows_all_columns() -> None:
    lines = repr(study()).splitlines()
    assert lines[0] == "Study: 2 finished, 1 invalid"
    assert lines[1].split() == ["case", "bodies.block.mass", "last", "<x>", "outcome", "message"]
    assert lines[4].split()[:3] == ["2", "-1", "invalid"]
    assert "found -1.0, expected a number > 0" in lines[4]
    page = read(study()._repr_html_())
    assert {"last <x>", "bodies.block.mass", "finished", "2 finished, 1 invalid"} <= set(page.texts)


def test_numbers_have_si_prefixes() -> None:
    assert quantity_text(1.79e8, "N/m²") == "179 MPa"
    assert quantity_text(-0.0123, "m") == "-12.3 mm"
    assert quantity_text(0.25, "m") == "0.25 m"
    assert quantity_text(1000.0, "N") == "1 kN"
    assert quantity_text(0.0, "N") == "0 N"
    assert quantity_text(1.79e8, "lbf/in²") == "1.790e+08 lbf/in²"
    assert quantity_text(1e6, "1") == "1000000"


def test_lists_and_tables_are_short() -> None:
    assert joined(["a", "b"]) == "a, b"
    assert joined([f"name{i}" for i in range(50)], 30) == "name0, name1, ..., name49"
    table = Table(["", "value"], [["a", "1"], ["long", "22"]])
    assert table.text() == "      value\na         1\nlong     22"
    assert "<td>a &lt; b</td>" in Table([""], [["a < b"]]).html()
