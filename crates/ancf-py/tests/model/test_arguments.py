"""Messages about the arguments of constructors."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import Any

import pytest

import ancf
import ancf.model

PLACE = ancf.Place("rod", "end")


def beam(name: str = "rod", **other: Any) -> ancf.Beam:
    """A beam with some arguments replaced by others."""
    given: dict[str, Any] = {
        "from_": [0, 0, 0],
        "to": [1, 0, 0],
        "elements": 8,
        "section": "strip",
        "material": "steel",
    }
    return ancf.Beam(name, **{key: value for key, value in (given | other).items() if value is not None})


MISTAKES: list[tuple[Callable[[], Any], str]] = [
    (
        lambda: beam(elements=None, elemnts=8),
        'Beam "rod": unknown argument elemnts; did you mean elements=8?',
    ),
    (
        lambda: beam(elements=None, from_=None, n=8, start=[0, 0, 0]),
        'Beam "rod": unknown argument n; did you mean elements=8?\n'
        'Beam "rod": unknown argument start; did you mean from_=[0, 0, 0]?',
    ),
    (
        lambda: beam(to=None, L=1.0),
        'Beam "rod": unknown argument L; did you mean to=1.0?',
    ),
    (
        lambda: ancf.Circle(radius=0.02),  # type: ignore[call-arg]
        "Circle: unknown argument radius; did you mean diameter=0.04, twice the radius?",
    ),
    (
        lambda: ancf.Circle("wire", r=0.02),  # type: ignore[call-arg]
        'Circle "wire": unknown argument r; did you mean diameter=0.04, twice the radius?',
    ),
    (
        lambda: ancf.Circle(0.02),  # type: ignore[arg-type, call-arg]
        "Circle: found the positional argument 0.02, expected keywords, such as Circle(diameter=0.02)",
    ),
    (
        lambda: ancf.Tube("pipe", 0.2, 0.1),  # type: ignore[call-arg]
        'Tube "pipe": found the positional arguments 0.2, 0.1, expected keywords, such as '
        "Tube('pipe', outer=0.2, inner=0.1)",
    ),
    (
        lambda: ancf.Material("steel", 7850.0, E=2.1e11),  # type: ignore[call-arg]
        'Material "steel": found the positional argument 7850.0, expected keywords, such as '
        "Material('steel', density=7850.0, young=...)",
    ),
    (
        lambda: ancf.Material(E=2.1e11, nu=0.3, rho=7850.0),  # type: ignore[call-arg]
        "Material: unknown argument E; did you mean young=210000000000.0?\n"
        "Material: unknown argument nu; did you mean poisson=0.3?\n"
        "Material: unknown argument rho; did you mean density=7850.0?",
    ),
    (
        lambda: ancf.Tube(outer=1.0),  # type: ignore[call-arg]
        "Tube: missing argument inner",
    ),
    (
        lambda: ancf.Spring(a=PLACE, k=3.0),  # type: ignore[call-arg]
        "Spring: unknown argument k; did you mean stiffness=3.0?\nSpring: missing arguments name and b",
    ),
    (
        lambda: ancf.Clamp("root", a=PLACE, colour="red"),  # type: ignore[call-arg]
        'Clamp "root": unknown argument colour; there are name, a, b and fix',
    ),
]


@pytest.mark.parametrize(("build", "message"), MISTAKES, ids=range(len(MISTAKES)))
def test_a_wrong_argument_names_the_correct_one(build: Callable[[], Any], message: str) -> None:
    with pytest.raises(TypeError, match=f"^{re.escape(message)}$"):
        build()


def test_an_error_names_the_part() -> None:
    with pytest.raises(ancf.ModelError) as caught:
        beam(elements="eight")
    assert str(caught.value) == 'Beam "rod": elements: found "eight", expected an integer >= 1'
    assert caught.value.errors[0].path == "elements"
    with pytest.raises(ancf.ModelError, match=r"^Circle: diameter: found -1, expected a number > 0$"):
        ancf.Circle(diameter=-1)


def test_a_body_instead_of_a_place_suggests_its_places() -> None:
    rod: Any = beam()
    message = 'Probe "tip": on: found a Beam, expected a Place; did you mean rod.start, rod.end or rod.at(s)?'
    with pytest.raises(TypeError, match=f"^{re.escape(message)}$"):
        ancf.Probe("tip", on=rod)
    block: Any = ancf.RigidBody("big block", center=[0, 0, 0], mass=1, inertia=[1, 1, 1])
    with pytest.raises(TypeError, match=re.escape("did you mean rigidbody.at() or rigidbody.at(point)?")):
        ancf.Clamp("root", a=block)
    # A material is no body.
    steel: Any = ancf.Material("steel", density=1, young=1)
    with pytest.raises(TypeError, match=r"on: found a Material, expected a Place$"):
        ancf.Probe("tip", on=steel)


def test_values_instead_of_parts_are_rejected() -> None:
    wrong: Any = "rod"
    message = """Probe "tip": on: found 'rod', expected a Place; did you mean Place("rod", "end")?"""
    with pytest.raises(TypeError, match=f"^{re.escape(message)}$"):
        ancf.Probe("tip", on=wrong)
    message = """b: found 'rod', expected 'ground', a Place or Ground; did you mean Place("rod", "end")?"""
    with pytest.raises(TypeError, match=f"{re.escape(message)}$"):
        ancf.Clamp("root", a=PLACE, b=wrong)
    assert ancf.Clamp("root", a=PLACE, b="ground").b == "ground"
    with pytest.raises(
        TypeError, match=r"analysis: found 'rod', expected a Dynamics, Statics, .* or Buckling$"
    ):
        ancf.Model(bodies=[beam()], analysis=wrong)
    with pytest.raises(
        TypeError, match=r"^bodies: found a Beam, expected a list of parts; did you mean bodies="
    ):
        ancf.Model(bodies=beam(), analysis=ancf.Modes())  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"model: found Beam\(.*\), expected an ancf.Model"):
        ancf.run(beam())


def test_a_force_function_is_positional() -> None:
    force = ancf.ExternalForce(lambda t, x, v: -x, on=PLACE)
    assert callable(force.name)


def test_help_shows_the_arguments() -> None:
    signature = inspect.signature(ancf.Beam)
    assert list(signature.parameters)[:4] == ["name", "from_", "to", "elements"]
    assert signature.parameters["elements"].kind is inspect.Parameter.KEYWORD_ONLY
    assert signature.parameters["elements"].default is inspect.Parameter.empty
    assert "diameter: 'float'" in str(inspect.signature(ancf.Circle))


def test_names_of_earlier_versions_point_to_the_new_ones() -> None:
    from ancf.names import RENAMED

    for old, new in RENAMED.items():
        assert hasattr(ancf, new)
        assert old not in ancf.__all__
        with pytest.raises(AttributeError, match=rf"ancf\.{old} is now called ancf\.{new}$"):
            getattr(ancf, old)
    with pytest.raises(AttributeError, match="did you mean 'Circle'"):
        ancf.Circel  # type: ignore[attr-defined] # noqa: B018
    assert not hasattr(ancf, "something_else")
