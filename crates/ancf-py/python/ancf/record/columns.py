"""Named columns of numbers."""

from __future__ import annotations

import numpy as np

from ancf.record.suggestion import unknown_name

Array = np.typing.NDArray[np.float64]
ComplexArray = np.typing.NDArray[np.complex128]

VECTORS: dict[str, tuple[str, ...]] = {
    "position": ("x", "y", "z"),
    "velocity": ("vx", "vy", "vz"),
    "acceleration": ("ax", "ay", "az"),
    "rotation": ("e0", "e1", "e2", "e3"),
    "angular_velocity": ("wx", "wy", "wz"),
    "accelerometer": ("imu_ax", "imu_ay", "imu_az"),
    "gyroscope": ("imu_wx", "imu_wy", "imu_wz"),
    "section_forces": ("N", "Qy", "Qz", "T", "My", "Mz"),
    "strain": ("exx", "eyy", "ezz", "exy", "exz", "eyz"),
    "stress": ("sxx", "syy", "szz", "sxy", "sxz", "syz"),
    "resultants": ("nuu", "nvv", "nuv", "muu", "mvv", "muv"),
    "surface_stress": tuple(
        f"s{component}_{layer}" for layer in ("top", "middle", "bottom") for component in ("uu", "vv", "uv")
    ),
    "force": ("fx", "fy", "fz"),
    "moment": ("mx", "my", "mz"),
}
"""Suffixes of the columns of each vector, after the name of the probe or the joint."""

JOINT_COORDINATES = ("angle", "rate", "displacement", "speed", "position", "length")
"""Suffixes of the columns of joint coordinates and their rates."""

ENERGIES = ("kinetic", "strain", "potential", "work", "dissipated", "balance")
"""Columns of energies."""


class Columns:
    """Numbers with named columns: all rows of a run, or one row."""

    # It is ambiguous whether an iteration means rows or columns.
    __iter__ = None

    def __init__(
        self,
        columns: list[str],
        data: Array,
        indices: dict[str, int] | None = None,
        units: dict[str, str] | None = None,
    ) -> None:
        """Store data `[..., column]`. The indices of the columns are computed if omitted."""
        self.columns = columns
        """Names of all columns."""
        self.data = data
        """All numbers, `[row, column]` or `[column]`."""
        self.indices = {name: i for i, name in enumerate(columns)} if indices is None else indices
        """Indices of the columns by name."""
        self.units = {} if units is None else units
        """Units of the columns by name, if the model names its `units`. Pure numbers have the unit `1`."""

    def __getitem__(self, column: str) -> Array:
        """Return a view of a column."""
        index = self.indices.get(column)
        if index is None:
            raise KeyError(unknown_name("column", column, self.columns))
        return self.data[..., index]

    def __contains__(self, column: object) -> bool:
        return column in self.indices

    def _ipython_key_completions_(self) -> list[str]:
        return self.columns

    def __repr__(self) -> str:
        rows = f"{len(self.data)} rows, " if self.data.ndim > 1 else ""
        return f"{type(self).__name__}({rows}{len(self.columns)} columns)"

    def vector(self, name: str, quantity: str) -> Array:
        """Return a view of a vector of a probe or a joint, `[..., component]`. Quantities are those of `VECTORS`."""
        names = [f"{name}.{suffix}" for suffix in VECTORS[quantity]]
        first = self.indices.get(names[0])
        if first is None or self.columns[first : first + len(names)] != names:
            msg = f"{name!r} has no {quantity}: it was not recorded"
            raise AttributeError(msg)
        return self.data[..., first : first + len(names)]
