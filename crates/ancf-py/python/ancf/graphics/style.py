"""Style of all figures: colours, grid, labels with units."""

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator

    from matplotlib.axes import Axes

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#444444")
"""Colours that remain distinct in colour blindness, after Okabe & Ito (2008)."""

GREY = "#b8b8b8"
"""Colour of the reference configuration."""

ARM_GREY = "#888888"
"""Colour of the arms of rigid bodies, and of rigid bodies beside bodies coloured by values."""


@contextmanager
def style() -> Iterator[None]:
    """Apply the style of all figures within a context. Settings outside remain unchanged."""
    import matplotlib.pyplot as plt
    from cycler import cycler

    settings: dict[Any, Any] = {
        "axes.axisbelow": True,
        "axes.edgecolor": "#777777",
        "axes.linewidth": 0.6,
        "axes.prop_cycle": cycler(linestyle=["-", "--", ":"]) * cycler(color=COLOURS),
        "axes.spines.right": False,
        "axes.spines.top": False,
        "axes.titlesize": "medium",
        "figure.constrained_layout.use": True,
        "legend.frameon": False,
        "legend.fontsize": "small",
        "lines.linewidth": 1.4,
        "lines.markersize": 3.5,
    }
    with plt.rc_context(settings):
        yield
        interactive = plt.isinteractive()
    # The first figure may have switched a notebook to interactive mode.
    plt.rcParams["interactive"] = interactive


def grid(ax: Axes) -> None:
    """Draw thin grid lines behind the curves."""
    ax.grid(visible=True, linewidth=0.4, color="#d5d5d5")


def colour_map(least: float, greatest: float) -> str:
    """Return the name of the colour map: diverging for limits symmetric about zero."""
    return "coolwarm" if least == -greatest else "viridis"


def colour_limits(values: np.typing.NDArray[np.float64]) -> tuple[float, float]:
    """Return the limits of the colour scale. Values of both signs give limits symmetric about zero."""
    known = values[np.isfinite(values)]
    least, greatest = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    far = max(abs(least), abs(greatest))
    if far == 0:
        return 0.0, 1.0
    # Limits within a thousandth of zero are zero up to numerical errors.
    least, greatest = (0.0 if abs(end) < 1e-3 * far else end for end in (least, greatest))
    return (-far, far) if least < 0 < greatest else (least, greatest)
