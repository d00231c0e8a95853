"""Derivatives of results with respect to numbers of a model."""

import numpy as np
import pytest

import ancf
from ancf import AnalysisError, AnalysisWarning, ModelError


def cantilever(analysis: ancf.Statics | ancf.Modes | ancf.Dynamics, width: float = 0.02) -> ancf.Model:
    beam = ancf.Beam(
        "beam",
        from_=[0, 0, 0],
        to=[1, 0, 0],
        elements=4,
        section=ancf.Rectangle(height=0.01, width=width, name="flat"),
        material=ancf.Material(density=7800, young=2.1e11, name="steel"),
    )
    return ancf.Model(
        bodies=[beam],
        joints=[ancf.Clamp("root", a=beam.start)],
        loads=[ancf.Force(on=beam.end, force=[0, 0, -10.0])],
        probes=[ancf.Probe("tip", on=beam.end)],
        analysis=analysis,
    )


def test_derivatives_agree_with_differences_of_runs() -> None:
    model = cantilever(ancf.Statics())
    found = ancf.gradients(model, ["materials.steel.young", "sections.flat.width", "loads[0].force[2]"])
    assert found.derivatives.shape == (len(found.quantities), 3)
    assert found.values[found.quantities.index("tip.z")] == pytest.approx(ancf.run(model)["tip.z"][-1])
    tips = [ancf.run(cantilever(ancf.Statics(), width))["tip.z"][-1] for width in (0.0199, 0.0201)]
    assert found["tip.z", "sections.flat.width"] == pytest.approx((tips[1] - tips[0]) / 2e-4, rel=1e-3)
    relative = found.relative[found.quantities.index("tip.z")]
    assert np.allclose(relative[[0, 2]], [-1, 1], atol=1e-3)


def test_frequencies() -> None:
    found = ancf.gradients(cantilever(ancf.Modes(count=2)), "materials.steel.density")
    assert found.quantities == ["frequency[0]", "frequency[1]"]
    assert np.allclose(found.relative, -0.5, atol=1e-9)
    with pytest.raises(KeyError, match=r"did you mean 'frequency\[0\]'"):
        found["frequenc[0]", "materials.steel.density"]


def test_equal_frequencies_warn() -> None:
    model = cantilever(ancf.Modes(count=2), width=0.01)
    with pytest.warns(AnalysisWarning, match="are equal"):
        found = ancf.gradients(model, "sections.flat.width")
    assert np.allclose(found.relative[:, 0], [0, 1], atol=1e-3)


def test_sizes_and_errors() -> None:
    model = cantilever(ancf.Statics())
    with pytest.raises(ModelError, match="0, to which changes have no proportion"):
        ancf.gradients(model, "gravity[2]")
    found = ancf.gradients(model, {"gravity[2]": 0.1})
    assert found["root.fz", "gravity[2]"] == pytest.approx(-7800 * 0.02 * 0.01, rel=1e-9)
    with pytest.raises(ModelError, match="statics, modes or buckling"):
        ancf.gradients(cantilever(ancf.Dynamics(duration=1, step=0.1)), "materials.steel.young")


def test_kinks_are_errors() -> None:
    block = ancf.PointMass("block", mass=2.0, center=[0, 0, 0])
    model = ancf.Model(
        gravity=[0, 0, -10],
        bodies=[block],
        joints=[
            ancf.PointOnLine("guide", a=block.at(), axis=[0, 0, 1]),
            ancf.Spring(
                "spring",
                a=block.at(),
                b=ancf.Ground(point=[0, 0, 1]),
                tension=ancf.ForceExpression("1000*x + 3000*max(x - 0.02, 0)"),
            ),
        ],
        analysis=ancf.Statics(),
    )
    with pytest.raises(AnalysisError, match="a stiffness has a kink there"):
        ancf.gradients(model, "bodies.block.mass")
