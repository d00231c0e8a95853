"""Stress and strain along bodies."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import ancf

FORCE, LENGTH, HEIGHT, WIDTH = 200.0, 1.0, 0.02, 0.03
OFFSET = (0.01, -0.015)
"""Corner of the section."""


@cache
def result() -> ancf.Result:
    """A cantilever of steel with a force at its tip across and along the axis."""
    beam = ancf.Beam(
        "beam",
        from_=[0, 0, 0],
        to=[LENGTH, 0, 0],
        elements=8,
        section=ancf.Rectangle(height=HEIGHT, width=WIDTH),
        material=ancf.Material("steel", density=7850, young=2.1e11, poisson=0.3),
    )
    return ancf.statics(
        ancf.Model(
            units=ancf.Units(length="m", time="s", force="N"),
            bodies=[beam],
            joints=[ancf.Clamp("root", a=beam.start)],
            loads=[ancf.Force(on=beam.end, force=[3 * FORCE, FORCE, 0])],
            probes=[
                ancf.Probe("corner", on=beam.at(0.5), offset=OFFSET, record=["strain", "stress"]),
                ancf.Probe("axis", on=beam.at(0.5), record=["strain", "stress"]),
            ],
            analysis=ancf.Modes(),
        )
    )


def test_fields_of_tensors_are_those_of_probes() -> None:
    run = result()
    station = [s for _, s in run.stations()].index(0.5)
    for probe, offset in (("corner", OFFSET), ("axis", None)):
        for name in ("strain", "stress"):
            field = run.field(name, offset=offset)
            assert field.shape == (len(run), 9, 6)
            np.testing.assert_allclose(field[:, station], getattr(run.probe(probe), name), rtol=1e-9)
    assert not np.allclose(run.field("stress", offset=OFFSET), run.field("stress"))
    with pytest.raises(ValueError, match="expected that of 'strain' or 'stress'"):
        run.field("position", offset=OFFSET)


def test_the_axial_stress_is_that_of_a_beam() -> None:
    run = result()
    forces = run.field("section_forces")[-1]
    expected = np.abs(forces[:, 0]) / (HEIGHT * WIDTH) + np.abs(forces[:, 5]) * 6 / (WIDTH * HEIGHT**2)
    stress = run.field("axial_stress", rows=-1)
    np.testing.assert_allclose(stress, expected, rtol=1e-6)
    # Bending of a cantilever by the force at its tip, up to the deflection.
    assert stress[0] == pytest.approx(FORCE * LENGTH * 6 / (WIDTH * HEIGHT**2) + 1e6, rel=0.1)
    assert run.field("bending_moment", "beam", parts=3).shape == (len(run), 25)
    np.testing.assert_allclose(run.field("bending_moment", rows=-1), np.abs(forces[:, 5]), rtol=1e-5)


def test_a_twisted_shaft_has_the_equivalent_stress_of_shear() -> None:
    diameter, torque = 0.02, 10.0
    shaft = ancf.Beam(
        "shaft",
        from_=[0, 0, 0],
        to=[1, 0, 0],
        elements=2,
        section=ancf.Circle(diameter=diameter),
        material=ancf.Material("steel", density=7850, young=2.1e11, poisson=0.3),
    )
    run = ancf.statics(
        ancf.Model(
            bodies=[shaft],
            joints=[ancf.Clamp("root", a=shaft.start)],
            loads=[ancf.Moment(on=shaft.end, moment=[torque, 0, 0])],
            analysis=ancf.Modes(),
        )
    )
    shear = 16 * torque / (np.pi * diameter**3)
    np.testing.assert_allclose(run.field("shear_stress", rows=-1), shear, rtol=1e-3)
    np.testing.assert_allclose(run.field("von_mises_stress", rows=-1), np.sqrt(3) * shear, rtol=1e-3)
    np.testing.assert_allclose(run.field("axial_stress", rows=-1), 0, atol=1e-2 * shear)


def test_a_dataset_has_scalar_fields_with_units() -> None:
    data = result().to_xarray(["axial_stress", "stress", "position"], parts=2)
    assert data["axial_stress"].dims == ("load", "station")
    assert data["axial_stress"].attrs["units"] == "N/m²"
    assert data["stress"].dims == ("load", "station", "tensor_component")
    assert data["stress"].attrs["units"] == "N/m²"


def test_rigid_bodies_have_no_stress() -> None:
    crank: Any = ancf.run(
        {
            "bodies": [
                {"kind": "rigid", "name": "block", "center": [0, 0, 0], "mass": 1, "inertia": [1, 1, 1]}
            ],
            "analysis": {"kind": "dynamics", "duration": 0.01, "step": 1e-3},
        }
    )
    assert np.isnan(crank.field("stress")).all()
    with pytest.raises(ValueError, match="no field 'axial_stress'"):
        crank.field("axial_stress")


def test_shapes_are_coloured_by_stress_with_a_prefix() -> None:
    run = result()
    for color, label in (
        ("axial_stress", "axial stress, MPa"),
        ("stress", "von Mises stress, MPa"),
        ("shear_stress", "shear stress, kPa"),
        ("sxx", "stress sxx, MPa"),
        ("exx", "strain exx"),
        ("strain", "strain"),
        ("shear_force", "shear force, N"),
        ("displacement.y", "displacement y, mm"),
    ):
        ax = run.plot_shape(color=color, parts=2)
        assert ax.figure.axes[1].get_ylabel() == label
    ax = run.plot_shape(color="axial_stress", parts=2)
    (bands,) = ax.collections
    assert bands.get_clim()[1] == pytest.approx(1e-6 * run.field("axial_stress", rows=-1, parts=2).max())
    mesh = run.scene(color="axial_stress", parts=2)
    assert mesh["axial_stress"].max() == pytest.approx(run.field("axial_stress", rows=-1, parts=2).max())


def damped(analysis: Any, **more: Any) -> ancf.Model:
    """Return a rubber bar that is pulled at a constant rate."""
    rubber = ancf.Material("rubber", density=1, young=5e6, poisson=0, damping=ancf.Damping(strain=0.05))
    bar = ancf.Beam(
        "bar",
        from_=[0, 0, 0],
        to=[1, 0, 0],
        elements=4,
        section=ancf.Rectangle(height=HEIGHT, width=WIDTH),
        material=rubber,
    )
    return ancf.Model(
        bodies=[bar],
        joints=[
            ancf.Clamp("root", a=bar.start),
            ancf.PrescribedMotion(
                "pull", a=bar.end, displacement=[0.1, 0, 0], time=ancf.Expression("t^2/(t+0.01)")
            ),
        ],
        probes=[ancf.Probe("middle", on=bar.at(0.5), record=["strain", "stress", "section_forces"])],
        analysis=analysis,
        **more,
    )


def test_stresses_contain_those_of_the_damping() -> None:
    """The stress times the stretch is the force per area; positions alone do not determine it."""
    model = damped(ancf.Dynamics(duration=0.5, step=5e-3))
    pulled = ancf.run(model)
    stretch = np.sqrt(1 + 2 * pulled["middle.exx"][-1])
    force = pulled["middle.N"][-1] / (HEIGHT * WIDTH)
    assert pulled["middle.sxx"][-1] * stretch == pytest.approx(force, rel=1e-3)
    field = pulled.field("stress", rows=-1)
    assert field[2, 0] == pytest.approx(pulled["middle.sxx"][-1], rel=1e-9)
    with pytest.raises(ValueError, match='states="all"'):
        ancf.run(model, states="positions").field("stress")


def test_stresses_of_modes_are_those_of_the_state() -> None:
    """A shape is no velocity: the undeformed state has no stress, with and without damping."""
    modes = ancf.modes(damped(ancf.Modes()), count=3)
    assert np.abs(modes.field("stress")).max() == 0
    assert np.abs(modes.field("section_forces")).max() == 0
    assert np.abs(modes.field("velocity")).max() > 0


def test_all_modes_are_recorded_for_any_interval() -> None:
    """The interval of the rows of a motion does not select modes."""
    motion = ancf.Dynamics(duration=0.1, step=1e-3)
    every, all_rows = (damped(motion, output=ancf.Output(every=n)) for n in (3, 1))
    found, expected = (ancf.modes(model, count=6) for model in (every, all_rows))
    np.testing.assert_array_equal(found.frequencies, expected.frequencies)
    assert len(found.frequencies) == len(found.shapes) == 6
