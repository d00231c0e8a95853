"""What is recorded and written."""

# Written by `cargo xtask schema` from the types of the program: change those.

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from ancf.model.places import Place
from ancf.part import Numbers, Part

__all__ = ["Output", "Probe", "Quantity"]

Quantity: TypeAlias = Literal["motion", "rotation", "section_forces", "strain", "stress"]
"""What a probe records.

* ``"motion"``: Position, velocity and acceleration of the point.
* ``"rotation"``: Euler parameters of the rotation of the section or the rigid body since the undeformed
  state, and its angular velocity in the global frame: ``e0``, ``e1``, ``e2``, ``e3``, ``wx``, ``wy``, ``wz``.
* ``"section_forces"``: Axial force, shear forces, torque and bending moments of the section, as the part
  beyond exerts them on the part before, in the frame of the section: ``N``, ``Qy``, ``Qz``, ``T``, ``My``,
  ``Mz``.
* ``"strain"``: Green's strain at the point in the frame of the section: ``exx``, ``eyy``, ``ezz``, ``exy``,
  ``exz``, ``eyz``.
* ``"stress"``: Second Piola-Kirchhoff stress at the point: ``sxx`` and so on.
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Probe(Part):
    """A place where motion, section forces, strain or stress are recorded.

    Attributes
    ----------
    name
        Name in the outputs: the columns are ``name.x``, ``name.vx``, ``name.ax`` and so on.
    on
        The place on the axis.
    offset
        Coordinates (y, z) of the point in the section, lengths; on the axis by default.
    record
        What is recorded; the motion by default.

    """

    _form = "Probe"

    name: str = field(kw_only=False)
    on: Place
    offset: Numbers | None = None
    record: Sequence[Quantity] | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Output(Part):
    """What is written, and how often.

    Attributes
    ----------
    csv
        Write ``probes.csv``. Default: ``True``.
    energy_parts
        Record the strain energy of each body by part. Default: ``False``.
    every
        Record every so many of these; the first and the last instant always are (>= 1). Default: ``1``.
    interval
        Time between recorded instants, on each of which a step ends; every step is recorded if left out (>
        0).
    parquet
        Write ``results.parquet``. Default: ``True``.
    states
        Keep about so many states for pictures and reports, evenly spaced in time, the first and the last
        among them; of equilibria, modes and critical loads all, unless 0 (>= 0). Default: ``200``.

    """

    _form = "Output"

    csv: bool | None = None
    energy_parts: bool | None = None
    every: int | None = None
    interval: float | None = None
    parquet: bool | None = None
    states: int | None = None
