"""Quantities by which bodies are coloured: values, labels with units, colour maps and limits.

The same quantities have the same colour maps in plots, scenes and reports: diverging for quantities with positive and
negative values in the result, sequential for all others.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ancf.display.numbers import display_unit, with_unit
from ancf.graphics.style import COLOUR_MAPS
from ancf.record.columns import VECTORS, Array
from ancf.record.suggestion import unknown_name

if TYPE_CHECKING:
    from ancf.record.result_data import ResultData

AXES = {"x": 0, "y": 1, "z": 2}

COLOUR_VECTORS = ("displacement", "velocity", "acceleration")
"""Vectors by which bodies can be coloured."""

COMPONENTS = {
    **{suffix: ("section_forces", i) for i, suffix in enumerate(VECTORS["section_forces"])},
    **{suffix: ("strain", i) for i, suffix in enumerate(VECTORS["strain"])},
    **{suffix: ("stress", i) for i, suffix in enumerate(VECTORS["stress"])},
    **{suffix: ("resultants", i) for i, suffix in enumerate(VECTORS["resultants"])},
    **{suffix: ("surface_stress", i) for i, suffix in enumerate(VECTORS["surface_stress"])},
}
"""Fields and numbers of the components that are known by their symbols, as the columns of probes."""

LABELS = {
    "N": "axial force N",
    "Qy": "shear force Qy",
    "Qz": "shear force Qz",
    "T": "torque T",
    "My": "bending moment My",
    "Mz": "bending moment Mz",
}
"""Labels of section forces."""

SYNONYMS = {"stress": "von_mises_stress", "von_mises": "von_mises_stress"}
"""Short names of scalar fields."""

SIGN_NOISE = 1e-6
"""Values below this fraction of the largest magnitude have no sign, as in reports."""

NOISE = 1e-3
"""Limits below this fraction of the other limit are zero."""


@dataclass(frozen=True)
class Quantity:
    """Values by which bodies are coloured, in all frames."""

    label: str
    unit: str | None
    is_signed: bool
    values: Array
    """Values `[frame, station]`, NaN where the quantity is not defined."""

    @property
    def colour_map(self) -> str:
        """Name of the colour map: diverging if a signed quantity has both signs in the result."""
        return str(COLOUR_MAPS["diverging" if self._has_both_signs else "sequential"])

    @property
    def _has_both_signs(self) -> bool:
        least, greatest = ends(self.values)
        far = SIGN_NOISE * max(-least, greatest)
        return self.is_signed and least < -far and greatest > far

    def limits(self, shown: Array) -> tuple[float, float]:
        """Return the limits of the colours of the shown values. Those of a diverging map are symmetric about zero."""
        least, greatest = ends(shown)
        far = max(abs(least), abs(greatest))
        if far == 0:
            return (-1.0, 1.0) if self._has_both_signs else (0.0, 1.0)
        if self._has_both_signs:
            return -far, far
        least, greatest = (0.0 if abs(end) < NOISE * far else end for end in (least, greatest))
        return (least, greatest) if least < greatest else (least, least + abs(least))

    def scaled(self, limits: tuple[float, float]) -> tuple[float, str]:
        """Return the factor of the values, and the label with the unit, such as 1e-6 and `axial stress, MPa`."""
        factor, unit = display_unit(max(map(abs, limits)), self.unit)
        return factor, with_unit(self.label, unit)


def ends(values: Array) -> tuple[float, float]:
    """Return the smallest and the largest finite value, or zeros if there is none."""
    known = values[np.isfinite(values)]
    return (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)


def quantity(result: ResultData, name: str, parts: int = 8) -> Quantity:
    """Compute a quantity by its name.

    Names are components of section forces, resultants, strain and stress such as `Mz`, `muu`, `exx`, `sxx`, `suu_top`;
    the magnitudes of `displacement`, `velocity`, `acceleration` and their components such as `displacement.y`; scalar
    fields of the report such as `axial_stress`. The `displacement` of a mode is its shape, relative to its maximum.
    """
    vector, _, component = name.partition(".")
    if name in COMPONENTS:
        field, index = COMPONENTS[name]
        label = LABELS.get(name, f"{field} {name}".replace("_", " "))
        numbers = result.field(field, parts=parts)
        values = numbers.reshape(*numbers.shape[:2], -1)[..., index]
        return Quantity(label, result.field_units.get(name), is_signed=True, values=values)
    if vector in COLOUR_VECTORS and (not component or component in AXES):
        return _of_vector(result, vector, component, parts)
    if not component and not result.is_modal:
        return _of_report(result, SYNONYMS.get(name, name), parts)
    raise KeyError(unknown_name("quantity", name, [*COMPONENTS, *COLOUR_VECTORS]))


def _of_vector(result: ResultData, vector: str, component: str, parts: int) -> Quantity:
    """Return the magnitude or a component of a vector."""
    unit, label = result.field_units.get(vector), f"{vector} {component}".strip()
    if result.is_modal and vector == "displacement":
        numbers = result.shape_at(parts=parts)
        largest = np.linalg.norm(numbers, axis=-1).max(axis=1, keepdims=True)
        numbers = numbers / np.where(largest > 0, largest, 1.0)[..., None]
        unit, label = None, f"relative {label}"
    else:
        numbers = result.field(vector, parts=parts)
    values: Array = numbers[..., AXES[component]] if component else np.linalg.norm(numbers, axis=-1)
    return Quantity(label, unit, is_signed=bool(component), values=values)


def _of_report(result: ResultData, name: str, parts: int) -> Quantity:
    """Return a scalar field of the report."""
    fields = result._scalar_fields(parts)
    if name not in fields:
        known = dict.fromkeys([*COMPONENTS, *COLOUR_VECTORS, *SYNONYMS, *fields])
        raise KeyError(unknown_name("quantity", name, list(known)))
    return Quantity(*fields[name])
