"""Style of all figures: colours, grid, labels with units."""

from __future__ import annotations

import json
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from ancf import _ancf

if TYPE_CHECKING:
    from collections.abc import Iterator

    from matplotlib.axes import Axes
    from matplotlib.colors import LinearSegmentedColormap

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#444444")
"""Colours that remain distinct in colour blindness, after Okabe & Ito (2008)."""

GREY = "#b8b8b8"
"""Colour of the reference configuration."""

SUPPORT_GREY = "#8a8a8a"
"""Colour of supports on the ground."""

ARM_GREY = "#888888"
"""Colour of the arms of rigid bodies, and of rigid bodies beside bodies coloured by values."""

COLOUR_MAPS: dict[str, Any] = json.loads(_ancf.COLOUR_MAPS)
"""Colour maps of quantities, as in reports: names of the sequential and the diverging map, and colours by name."""


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


def colour_map(name: str) -> LinearSegmentedColormap:
    """Return one of the colour maps of reports."""
    from matplotlib.colors import LinearSegmentedColormap

    colours = COLOUR_MAPS["maps"][name].split()
    return LinearSegmentedColormap.from_list(name, [f"#{colour}" for colour in colours])
