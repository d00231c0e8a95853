"""The whole model."""

# Written by `cargo xtask schema` from the types of the program: change those.

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

from ancf.document import Document
from ancf.model.analyses import Analysis
from ancf.model.bodies import Body
from ancf.model.contacts import Contact
from ancf.model.couplings import Coupling
from ancf.model.joints import Joint
from ancf.model.loads import Load
from ancf.model.materials import Material
from ancf.model.output import Output, Probe
from ancf.model.sections import Section
from ancf.part import Part, Vector

__all__ = ["AutoScales", "GivenScales", "Model", "NoScales", "PaperScales", "ScaleChoice", "Units"]


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class NoScales(Part):
    """The user's own: the dimensional form."""

    _form = "ScaleChoice"
    _tag = "kind"
    kind: ClassVar[Literal["none"]] = "none"


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class PaperScales(Part):
    """Of Kim et al. (2017): length of the beam, weight of one element, time by eq. (7).

    For one beam under gravity.
    """

    _form = "ScaleChoice"
    _tag = "kind"
    kind: ClassVar[Literal["paper"]] = "paper"


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class AutoScales(Part):
    """The longest body's length L.

    The weight of that body, or E I/L² without gravity; time by eq. (7); each rounded to a power of two, so
    that nothing is lost on the way to these units and back.
    """

    _form = "ScaleChoice"
    _tag = "kind"
    kind: ClassVar[Literal["auto"]] = "auto"


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class GivenScales(Part):
    """Given by number.

    Attributes
    ----------
    length
        Unit of length (> 0).
    force
        Unit of force (> 0).
    time
        Unit of time; by eq. (7) with the ρA of the longest body if left out (> 0).

    """

    _form = "ScaleChoice"
    _tag = "kind"
    kind: ClassVar[Literal["given"]] = "given"

    length: float
    force: float
    time: float | None = None


ScaleChoice: TypeAlias = NoScales | PaperScales | AutoScales | GivenScales
"""How the units of the equations are chosen."""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Units(Part):
    """What the units of the model's numbers are called.

    Nothing is converted: these are names for axes, legends and result files.

    Attributes
    ----------
    length
        The unit of length, such as ``"m"``.
    time
        The unit of time, such as ``"s"``.
    force
        The unit of force, such as ``"N"``.

    """

    _form = "Units"

    length: str
    time: str
    force: str


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Model(Document):
    """A flexible multibody model.

    Every number is in your own coherent units (m-kg-s, mm-t-s, ...).

    Attributes
    ----------
    bodies
        The bodies, flexible and rigid.
    analysis
        What to compute.
    assemble
        Whether gaps between the places of joints are closed before the analysis begins; they are refused by
        default.
    contacts
        What bodies may touch: obstacles and each other.
    couplings
        Gears, racks, belts: joints that move together.
    gravity
        Acceleration of gravity, length/time²; no gravity by default.
    joints
        Joints that tie bodies to the ground or to each other.
    loads
        Loads besides gravity.
    materials
        Materials by name.
    output
        What is written, and how often. Default: ``Output(csv=True, energy_parts=False, every=1, parquet=True,
        states=200)``.
    probes
        Points whose motion is recorded.
    scales
        Units in which the equations are solved; the user's own by default.
    sections
        Cross-sections by name.
    title
        A line that says what this model is.
    units
        What its units are called, for axes and result files; nothing is converted.

    """

    _form = "Model"

    bodies: Sequence[Body]
    analysis: Analysis
    assemble: bool | None = None
    contacts: Sequence[Contact] | None = None
    couplings: Sequence[Coupling] | None = None
    gravity: Vector | None = None
    joints: Sequence[Joint] | None = None
    loads: Sequence[Load] | None = None
    materials: Mapping[str, Material] | None = None
    output: Output | None = None
    probes: Sequence[Probe] | None = None
    scales: ScaleChoice | None = None
    sections: Mapping[str, Section] | None = None
    title: str | None = None
    units: Units | None = None
