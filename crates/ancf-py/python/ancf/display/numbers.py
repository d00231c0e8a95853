"""Numbers and units as text."""

from __future__ import annotations

import numpy as np

PREFIXES = {-9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}
"""SI prefixes by the power of ten."""

PREFIXED = ("N", "Pa", "J", "Hz", "N m", "m", "m/s", "m/s²")
"""Units that accept an SI prefix."""

DERIVED = {"N/m²": "Pa", "1/s": "Hz"}
"""Names of SI units."""


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


def energy_unit(unit: str | None) -> str | None:
    """Return the unit of energies and work: J instead of N m, which remains the unit of moments."""
    return "J" if unit == "N m" else unit


def si_prefix(size: float, unit: str | None) -> tuple[float, str | None]:
    """Return the factor and the unit by which numbers up to a size have few digits, such as 1e-6 and MPa.

    Units that are not those of the SI keep their names, with the factor 1.
    """
    unit = DERIVED.get(unit or "", unit)
    if unit not in PREFIXED or not 0 < size < np.inf:
        return 1.0, unit
    power = int(np.clip(3 * np.floor(np.log10(size * (1 + 1e-9)) / 3), min(PREFIXES), max(PREFIXES)))
    # 0.25 m is easier to read than 250 mm, also as 10 N rather than 0.01 kN.
    power = 0 if 0.1 <= size < 1000 else power
    return 10.0**-power, f"{PREFIXES[power]}{unit}"


def quantity_text(number: float, unit: str | None) -> str:
    """Return a number with its unit and an SI prefix, such as 179 MPa."""
    factor, unit = si_prefix(abs(number), unit)
    return with_unit(format_number(factor * number), unit, " ")
