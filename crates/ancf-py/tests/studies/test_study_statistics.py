"""Studies: samples, convergence, Monte Carlo, sensitivity."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import scipy.stats

import ancf
from ancf.studies.indices import parts

# Of a round bar of steel, clamped at one end: the tip's deflection under its own weight, q L^4 / (8 E I).
DIAMETER, YOUNG, DENSITY = 0.02, 193e9, 8030.0
WEIGHT = DENSITY * np.pi / 4 * DIAMETER**2 * 9.81
SAG_TIMES_YOUNG = WEIGHT / (8 * np.pi / 64 * DIAMETER**4)


@pytest.mark.parametrize("sampling", ["latin_hypercube", "sobol"])
def test_one_sample_in_each_interval(bar: dict[str, Any], sampling: Any) -> None:
    parameters = {
        "bodies.beam.material.young": scipy.stats.norm(193e9, 5e9),
        "gravity[1]": scipy.stats.norm(-9, 1),
    }
    table = ancf.study(bar, parameters, samples=16, sampling=sampling).table
    intervals = [(16 * law.cdf(table[path])).astype(int) for path, law in parameters.items()]
    for interval in intervals:
        assert sorted(interval) == list(range(16))
    assert list(intervals[0]) != list(intervals[1])


def test_the_seed_determines_the_cases(bar: dict[str, Any]) -> None:
    def young(seed: int, sampling: Any, samples: int = 8, **more: Any) -> list[float]:
        parameters = {"bodies.beam.material.young": scipy.stats.norm(193e9, 5e9), **more}
        return list(
            ancf.study(bar, parameters, samples=samples, seed=seed, sampling=sampling).table[
                "bodies.beam.material.young"
            ]
        )

    for sampling in ["latin_hypercube", "random", "sobol"]:
        assert young(1, sampling) == young(1, sampling)
        assert set(young(1, sampling)).isdisjoint(young(2, sampling))
    # Samples are independent of other distributions. A larger number of samples extends a smaller one.
    other = {"gravity[1]": scipy.stats.norm(-9, 1)}
    for sampling in ["latin_hypercube", "random"]:
        assert young(1, sampling, **other) == young(1, sampling)
    for sampling in ["random", "sobol"]:
        assert young(1, sampling, 12)[:8] == young(1, sampling)
    integers = ancf.study(bar, {"elements": scipy.stats.randint(1, 9)}, samples=8, seed=3)
    assert list(integers.finished["elements"].sort_values()) == list(range(1, 9))


def test_convergence_of_order_two(bar: dict[str, Any]) -> None:
    study = ancf.study(bar, {"elements": [4, 1, 2, 16, 8]}, {"tip": "tip.y"})
    table = study.convergence("elements", "tip")
    assert list(table["elements"]) == [1, 2, 4, 8, 16]
    assert list(table["order"][2:]) == pytest.approx([2, 2, 2], abs=0.02)
    # The contribution of shear is 1e-4 of the deflection.
    assert table["limit"].iloc[-1] == pytest.approx(-SAG_TIMES_YOUNG / YOUNG, rel=5e-4)
    assert table["error"].iloc[-1] == pytest.approx(-table["limit"].iloc[-1] / (3 * 16**2), rel=0.02)
    both = ancf.study(bar, {"elements": [1, 2, 4], "gravity[1]": [-9.81, -1.62]}, {"tip": "tip.y"})
    with pytest.raises(ValueError, match="varies too"):
        both.convergence("elements", "tip")
    assert len(both.convergence("elements", "tip", where={"gravity[1]": -1.62})) == 3
    with pytest.raises(KeyError, match="did you mean 'tip'"):
        both.convergence("elements", "tipp")


def test_monte_carlo_of_the_sag(bar: dict[str, Any]) -> None:
    law = scipy.stats.lognorm(0.05, scale=YOUNG)
    parameters = {"bodies.beam.material.young": law, "elements": [20]}
    study = ancf.study(bar, parameters, {"tip": "tip.y"}, samples=400, seed=1, sampling="random")
    # 1/E is distributed lognormally as well.
    inverse = scipy.stats.lognorm(0.05, scale=1 / YOUNG)
    mean, deviation = SAG_TIMES_YOUNG * inverse.mean(), SAG_TIMES_YOUNG * inverse.std()
    sag = -study.finished["tip"]
    assert len(sag) == 400
    # Four standard errors, and the discretisation error of 1/1200 of twenty elements.
    assert sag.mean() == pytest.approx(mean * (1 - 1 / 1200), abs=4 * deviation / np.sqrt(400))
    assert sag.var() == pytest.approx(deviation**2, rel=4 * np.sqrt(2 / 400))


def test_sensitivity_of_a_pushed_bar(pushed: dict[str, Any]) -> None:
    parameters = {
        "bodies.beam.section.diameter": scipy.stats.uniform(0.019, 0.002),
        "bodies.beam.material.young": scipy.stats.norm(YOUNG, 5e9),
        "elements": [4],
    }
    study = ancf.study(pushed, parameters, {"tip": "tip.y"}, samples=128)
    table = study.sensitivity("tip")
    # F L^3 / (3 E I) with I ~ d^4.
    assert table["elasticity"]["bodies.beam.section.diameter"] == pytest.approx(-4, abs=0.01)
    assert table["elasticity"]["bodies.beam.material.young"] == pytest.approx(-1, abs=0.01)
    assert "elements" not in table.index
    # For independent parameters the squares are fractions of the variance, known for the logarithms.
    variances = np.square([4 * 0.002 / np.sqrt(12) / 0.02, 5e9 / YOUNG])
    shares = table["regression"][["bodies.beam.section.diameter", "bodies.beam.material.young"]] ** 2
    assert list(shares) == pytest.approx(list(variances / variances.sum()), abs=0.05)
    assert table["rank"]["bodies.beam.section.diameter"] > 0.95
    assert table.attrs["r2"] > 0.98
    assert len(study.plot()) == 3


def test_sobol_indices_of_a_product(pushed: dict[str, Any]) -> None:
    laws = {
        "bodies.beam.section.diameter": scipy.stats.uniform(0.015, 0.01),
        "bodies.beam.material.young": scipy.stats.uniform(100e9, 200e9),
    }
    with pytest.raises(ancf.ModelError) as caught:
        ancf.sobol(pushed, laws | {"elements": [4]}, {"tip": "tip.y"}, samples=100)
    assert str(caught.value).splitlines() == [
        "parameters.elements: found [4], expected a distribution, such as scipy.stats.norm(mean, deviation)",
        "samples: found 100, expected a power of 2, as in a Sobol sequence (such as 256)",
    ]
    table = ancf.sobol(pushed, laws, {"tip": "tip.y", "end": ("tip.y", "min")}, samples=512)
    # The tip's deflection is a product of functions g of one parameter each, with relative variances v:
    # (1 + v1)(1 + v2) - 1 = v1 + v2 + v1 v2 (Saltelli & Sobol 1995).
    places = (np.arange(100_000) + 0.5) / 100_000
    relative = []
    for path, power in zip(laws, [-4, -1], strict=True):
        g = laws[path].ppf(places) ** power
        relative.append(g.var() / g.mean() ** 2)
    whole = np.prod(np.add(relative, 1)) - 1
    for path, v, other in zip(laws, relative, reversed(relative), strict=True):
        assert table["first"]["tip", path] == pytest.approx(v / whole, abs=0.03)
        assert table["total"]["tip", path] == pytest.approx(v * (1 + other) / whole, abs=0.03)
    assert len(table) == 4


def test_indices_equal_those_of_scipy(pushed: dict[str, Any]) -> None:
    laws = {
        "bodies.beam.section.diameter": scipy.stats.uniform(0.015, 0.01),
        "elements": scipy.stats.randint(1, 5),
    }
    seen: list[int] = []

    def tip(result: ancf.Result) -> float:
        seen.append(result.model["bodies"][0]["elements"])
        return float(result["tip.y"][-1])

    table = ancf.sobol(pushed, laws, {"tip": tip}, samples=16, seed=np.int64(2), jobs=1)
    assert set(seen) == {1, 2, 3, 4} and all(isinstance(count, int) for count in seen)
    assert len(seen) == 16 * 4
    values = np.random.default_rng(0).random((3, 5, 8))
    blocks = {"f_A": values[:, 0], "f_B": values[:, 1], "f_AB": values[:, 2:].swapaxes(0, 1)}
    theirs = scipy.stats.sobol_indices(func=blocks, n=8)
    first, total = parts(values)
    np.testing.assert_allclose(first, np.ravel(theirs.first_order), rtol=1e-12)
    np.testing.assert_allclose(total, np.ravel(theirs.total_order), rtol=1e-12)
    assert len(table) == 2


def test_a_single_parameter_has_index_one(pushed: dict[str, Any]) -> None:
    law = {"bodies.beam.material.young": scipy.stats.uniform(100e9, 200e9)}
    table = ancf.sobol(pushed, law, {"tip": "tip.y"}, samples=256)
    assert list(table.to_numpy()[0]) == pytest.approx([1, 1], abs=0.05)
    # A constant has no indices.
    assert ancf.sobol(pushed, law, lambda _: 1.0, samples=2).isna().to_numpy().all()


def test_indices_need_numbers(pushed: dict[str, Any]) -> None:
    law: Any = {"bodies.beam.material.young": scipy.stats.uniform(100e9, 200e9)}

    with pytest.raises(
        ValueError, match=r"objectives\.o: found no number in 12 of 12 cases, expected one in each"
    ):
        ancf.sobol(pushed, law, {"o": lambda _: np.nan}, samples=4)
    with pytest.raises(ancf.ModelError) as caught:
        ancf.sobol(pushed, {}, None, samples="x", seed=-1, combine="grid")  # type: ignore[arg-type]
    assert str(caught.value).splitlines() == [
        "parameters: found none, expected at least one distribution",
        "objective: found none, expected at least one number",
        'samples: found "x", expected a power of 2, as in a Sobol sequence (such as 256)',
        "seed: found -1, expected an integer from 0 to 4294967295",
        'combine: found "grid", expected nothing, since the Sobol sequence determines the cases',
    ]
    with pytest.raises(ancf.ModelError) as caught:
        ancf.sobol(pushed, {f"p{k}": law for k in range(241)}, "tip.y", samples=2**40, seed=2**32)
    assert [line for line in str(caught.value).splitlines() if "distribution, such" not in line] == [
        "samples: found 1099511627776, expected at most 10000000",
        "seed: found 4294967296, expected an integer from 0 to 4294967295",
        "parameters: found 241 distributions, expected at most 240 in a Sobol sequence",
    ]
    with pytest.raises(ancf.ModelError, match="parameters: found 3, expected a dictionary"):
        ancf.sobol(pushed, 3, "tip.y", samples=4)  # type: ignore[arg-type]
