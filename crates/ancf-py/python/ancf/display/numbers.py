"""Numbers and units as text."""

from __future__ import annotations

import math

import numpy as np

PREFIXES = {-3: "n", -2: "µ", -1: "m", 0: "", 1: "k", 2: "M", 3: "G"}
"""SI prefixes by the power of 1000."""

SI_UNITS = {
    "m": ("m", 1.0, -3, 1),
    "s": ("s", 1.0, -3, 0),
    "N": ("N", 1.0, -2, 3),
    "J": ("J", 1.0, -3, 3),
    "W": ("W", 1.0, -3, 3),
    "Hz": ("Hz", 1.0, -1, 3),
    "1/s": ("Hz", 1.0, -1, 3),
    "N m": ("N m", 1.0, -2, 3),
    "m/s": ("m/s", 1.0, -2, 1),
    "m/s²": ("m/s²", 1.0, -2, 1),
    "N/m": ("N/m", 1.0, -1, 3),
    "N/m²": ("Pa", 1.0, -2, 3),
    "N/mm²": ("Pa", 1e6, -2, 3),
}
"""Symbol with a prefix, factor from the given unit, least and largest power of 1000, as in the report."""


def format_number(number: float, digits: int = 4) -> str:
    """Format a number in four digits, without exponent if it is of moderate size."""
    if number == 0 or 1e-4 <= abs(number) < 1e7:
        return np.format_float_positional(float(f"{number:.{digits}g}"), trim="-")
    return f"{number:.{digits - 1}e}"


def with_unit(text: str, unit: str | None, separator: str = ", ") -> str:
    """Append a unit to a text, unless it is missing or that of pure numbers."""
    if unit in {None, "", "1"}:
        return text
    return f"{text}{separator}{unit}" if text else str(unit)


def display_unit(size: float, unit: str | None) -> tuple[float, str]:
    """Return factor and unit that give numbers up to a size few digits, such as 1e-6 and MPa.

    Numbers from 0.1 to 1 have no prefix. Units that are not those of the SI keep their names, with the factor 1.
    """
    symbol, factor, least, most = SI_UNITS.get(unit or "", ("", 1.0, 0, 0))
    size *= factor
    if not symbol or not 0 < size < np.inf:
        return 1.0, unit or ""
    # The tolerance keeps 999.96, which is displayed as 1000, out of the smaller unit.
    thousands = math.floor(math.log10(size * 1.00005) / 3)
    power = 0 if 0.1 <= size < 1 else min(most, max(least, thousands))
    if not 1e-3 * 1000.0**power <= size < 1e5 * 1000.0**power:
        return 1.0, unit or ""
    return factor / 1000.0**power, PREFIXES[power] + symbol


def quantity_text(number: float, unit: str | None) -> str:
    """Return a number with its unit and an SI prefix, such as 179 MPa."""
    factor, unit = display_unit(abs(number), unit)
    return with_unit(format_number(factor * number), unit, " ")
