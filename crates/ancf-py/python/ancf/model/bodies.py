"""Bodies, flexible and rigid."""

# Written by `cargo xtask schema` from the types of the program: change those.

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar, Literal, TypeAlias

from ancf.axis import Axis, Frame, Point
from ancf.model.materials import Material
from ancf.model.sections import Section
from ancf.part import Part, Points, Vector

__all__ = [
    "Arc",
    "Beam",
    "Body",
    "Cable",
    "Formulation",
    "Helix",
    "InitialMotion",
    "PointMass",
    "RigidBody",
    "Shape",
    "Slopes",
    "Spline",
    "Straight",
]

Formulation: TypeAlias = Literal["continuum", "enhanced", "linked", "quadratic"]
"""Which element, and which of its strains are how stiff.

* ``"continuum"``: Two nodes, 24 coordinates, three-dimensional elasticity: that of Kim et al. (2017), with
  its locking. Bending has (λ+2G) I for E I, torsion the polar moment of area, and errors fall with 1/(3n²).
* ``"enhanced"``: The same element with the elasticity of a rod: Poisson's effect on the axis only, shear
  factors, St. Venant's torsion constant (Gerstmayr, Matikainen & Mikkola 2008).
* ``"linked"``: The same with linked strains, which frees it from shear locking: one element is exact for end
  loads.
* ``"quadratic"``: Three nodes, 27 coordinates, with the elasticity of a rod, integrated at two points
  (Nachbagauer, Gruber & Gerstmayr 2013).
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class InitialMotion(Part):
    """How a body moves at the start of a motion: as a rigid one, v(r) = v₀ + ω × (r − c).

    Attributes
    ----------
    about
        The point c, length; the start of the axis, or the centre of a rigid body, by default.
    spin
        Angular velocity ω in the global frame, radians/time. Default: ``[0.0, 0.0, 0.0]``.
    velocity
        Velocity v₀ of the point ``about``, length/time. Default: ``[0.0, 0.0, 0.0]``.

    """

    _form = "InitialMotion"

    about: Vector | None = None
    spin: Vector | None = None
    velocity: Vector | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Straight(Part):
    """Along a line."""

    _form = "Shape"
    _tag = "kind"
    kind: ClassVar[Literal["straight"]] = "straight"


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Arc(Part):
    """Along the arc of a circle.

    Attributes
    ----------
    through
        A point between start and end.

    """

    _form = "Shape"
    _tag = "kind"
    kind: ClassVar[Literal["arc"]] = "arc"

    through: Vector


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Helix(Part):
    """Along a helix.

    Attributes
    ----------
    center
        A point of the helix's axis.
    axis
        Direction of the helix's axis; the helix turns about it by the right hand.
    turns
        Number of turns (> 0).

    """

    _form = "Shape"
    _tag = "kind"
    kind: ClassVar[Literal["helix"]] = "helix"

    center: Vector
    axis: Vector
    turns: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Spline(Part):
    """Along a natural cubic spline.

    Attributes
    ----------
    through
        The points between start and end.

    """

    _form = "Shape"
    _tag = "kind"
    kind: ClassVar[Literal["spline"]] = "spline"

    through: Points


Shape: TypeAlias = Straight | Arc | Helix | Spline
"""How the axis of a beam goes from its start to its end in the reference state, which is free of stress."""

Slopes: TypeAlias = Literal["gradient", "length"]
"""What the slope coordinates of a node are: ℓ r_x, ℓ r_y, ℓ r_z.

* ``"gradient"``: The gradients themselves, ℓ = 1 (Kim et al. 2017, eq. 2).
* ``"length"``: The gradients times the length of an element, ℓ = l (Kim et al. 2017, eq. 10).
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Beam(Axis):
    """A beam that bends, twists, stretches and shears.

    Attributes
    ----------
    name
        The name by which joints, loads and probes refer to the beam.
    from_
        Where the axis starts, length.
    to
        Where the axis ends, length.
    elements
        Number of elements, all of one length (>= 1).
    section
        Name of the section, a key of ``sections``. Or the section itself.
    material
        Name of the material, a key of ``materials``. Or the material itself.
    formulation
        Which element, and which of its strains are how stiff. One of ``"continuum"``, ``"enhanced"``,
        ``"linked"``, ``"quadratic"``. Default: ``"continuum"``.
    motion
        How it moves at the start of a motion; at rest by default.
    section_end
        Name of the section at the end, of the same kind; sizes in between are interpolated linearly. The same
        by default. Or the section itself.
    shape
        How the axis goes from start to end; straight by default. Free of stress.
    slopes
        What the nodal slope coordinates are. One of ``"gradient"``, ``"length"``. Default: ``"gradient"``.
    twist
        Angle by which the section turns about the axis from start to end, in radians; free of stress.
        Default: ``0.0``.
    up
        A direction that fixes the section's y-axis at the start: its part normal to the axis. Global y by
        default, global z for a beam along y.

    """

    _form = "Body"
    _tag = "kind"
    kind: ClassVar[Literal["beam"]] = "beam"
    _tables: ClassVar[Mapping[str, str]] = {
        "section": "sections",
        "material": "materials",
        "section_end": "sections",
    }

    name: str = field(kw_only=False)
    from_: Vector
    to: Vector
    elements: int
    section: str | Section
    material: str | Material
    formulation: Formulation | None = None
    motion: InitialMotion | None = None
    section_end: str | Section | None = None
    shape: Shape | None = None
    slopes: Slopes | None = None
    twist: float | None = None
    up: Vector | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Cable(Axis):
    """A cable: a line that stretches and bends, equally about every axis across, and has no torsion.

    Attributes
    ----------
    name
        The name by which joints, loads and probes refer to the cable.
    from_
        Where the axis starts, length.
    to
        Where the axis ends, length.
    elements
        Number of elements, all of one length (>= 1).
    section
        Name of the section, a key of ``sections``; it bends equally about every axis across. Or the section
        itself.
    material
        Name of the material, a key of ``materials``. Or the material itself.
    motion
        How it moves at the start of a motion; at rest by default.
    slopes
        What the nodal slope coordinates are. One of ``"gradient"``, ``"length"``. Default: ``"gradient"``.

    """

    _form = "Body"
    _tag = "kind"
    kind: ClassVar[Literal["cable"]] = "cable"
    _tables: ClassVar[Mapping[str, str]] = {
        "section": "sections",
        "material": "materials",
    }

    name: str = field(kw_only=False)
    from_: Vector
    to: Vector
    elements: int
    section: str | Section
    material: str | Material
    motion: InitialMotion | None = None
    slopes: Slopes | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class RigidBody(Frame):
    """A body that does not deform.

    Attributes
    ----------
    name
        The name by which joints, loads and probes refer to the body.
    center
        Centre of mass at the start, length.
    mass
        Mass, force time²/length (> 0).
    inertia
        Moments of inertia ``[xx, yy, zz]`` about the centre along the global axes at the start, mass length².
    motion
        How it moves at the start of a motion; at rest by default.
    products
        Off-diagonal entries ``[xy, xz, yz]`` of the same tensor; none by default.

    """

    _form = "Body"
    _tag = "kind"
    kind: ClassVar[Literal["rigid"]] = "rigid"

    name: str = field(kw_only=False)
    center: Vector
    mass: float
    inertia: Vector
    motion: InitialMotion | None = None
    products: Vector | None = None


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class PointMass(Point):
    """A point mass.

    Attributes
    ----------
    name
        The name by which joints, loads and probes refer to the mass.
    center
        Where it is at the start, length.
    mass
        Mass, force time²/length (> 0).
    motion
        How it moves at the start of a motion; at rest by default.

    """

    _form = "Body"
    _tag = "kind"
    kind: ClassVar[Literal["mass"]] = "mass"

    name: str = field(kw_only=False)
    center: Vector
    mass: float
    motion: InitialMotion | None = None


Body: TypeAlias = Beam | Cable | RigidBody | PointMass
"""A body of the model."""
