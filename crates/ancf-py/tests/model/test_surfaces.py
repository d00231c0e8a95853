"""Thin shells through arrays of points, and their prestrain."""

import numpy as np
import pytest

import ancf


def test_a_lofted_membrane_of_an_array_is_stretched() -> None:
    """An array of shape (m, n, 3) is the sections. A square membrane under a tension has f² = n/(2 ρ h a²)."""
    u, v = np.meshgrid(np.linspace(0, 2, 4), np.linspace(0, 2, 3))
    sail = ancf.Shell(
        "sail",
        surface=ancf.LoftedSurface(sections=np.stack([u, v, 0 * u], axis=-1)),
        elements=[8, 8],
        thickness=1e-4,
        material=ancf.Material(density=1400, young=4e9, poisson=0.3),
    )
    names: list[ancf.EdgeName] = ["u_start", "u_end", "v_start", "v_end"]
    edges = [ancf.Support(name, a=sail.edge(name), condition="hinged") for name in names]
    model = ancf.Model(
        bodies=[sail],
        joints=edges,
        loads=[ancf.SurfacePrestrain(body="sail", tension=[400, 400, 0])],
        analysis=ancf.Modes(about="equilibrium", count=1),
    )
    exact = np.sqrt(400 / (2 * 1400 * 1e-4)) / 2
    assert ancf.run(model)["frequency"][0] == pytest.approx(exact, rel=2e-3)
