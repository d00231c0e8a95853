"""Cross-sections."""

# Written by `cargo xtask schema` from the types of the program: change those.

from dataclasses import dataclass
from typing import ClassVar, Literal, TypeAlias

from ancf.part import Shared

__all__ = ["Circle", "Ellipse", "GeneralSection", "Rectangle", "Section", "Tube"]


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Circle(Shared):
    """A full circle.

    Attributes
    ----------
    name
        Key in the model's table, for a part that is given in the place of its name; found by itself if left
        out.
    diameter
        Diameter, length (> 0).

    """

    _form = "Section"
    _tag = "kind"
    kind: ClassVar[Literal["circle"]] = "circle"

    diameter: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Tube(Shared):
    """A circular tube.

    Attributes
    ----------
    name
        Key in the model's table, for a part that is given in the place of its name; found by itself if left
        out.
    outer
        Outer diameter, length (> 0).
    inner
        Inner diameter, length; less than the outer (> 0).

    """

    _form = "Section"
    _tag = "kind"
    kind: ClassVar[Literal["tube"]] = "tube"

    outer: float
    inner: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Rectangle(Shared):
    """A full rectangle.

    Attributes
    ----------
    name
        Key in the model's table, for a part that is given in the place of its name; found by itself if left
        out.
    height
        Extent along the section's y-axis, length (> 0).
    width
        Extent along the section's z-axis, length (> 0).

    """

    _form = "Section"
    _tag = "kind"
    kind: ClassVar[Literal["rectangle"]] = "rectangle"

    height: float
    width: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Ellipse(Shared):
    """A full ellipse.

    Attributes
    ----------
    name
        Key in the model's table, for a part that is given in the place of its name; found by itself if left
        out.
    height
        Extent along the section's y-axis, length: twice that semi-axis (> 0).
    width
        Extent along the section's z-axis, length: twice that semi-axis (> 0).

    """

    _form = "Section"
    _tag = "kind"
    kind: ClassVar[Literal["ellipse"]] = "ellipse"

    height: float
    width: float


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class GeneralSection(Shared):
    """A section known by its numbers only, with moduli E and G of its material.

    Attributes
    ----------
    name
        Key in the model's table, for a part that is given in the place of its name; found by itself if left
        out.
    area
        Area A, length² (> 0).
    iy
        Second moment ∫z² dA, length⁴: for bending about y, deflections along z (> 0).
    iz
        Second moment ∫y² dA, length⁴: for bending about z, deflections along y (> 0).
    j
        Torsion constant, length⁴; iy + iz by default (> 0).
    ky
        Shear factor of forces along y: their stiffness is ky G A; 1 by default (> 0).
    kz
        Shear factor of forces along z: their stiffness is kz G A; 1 by default (> 0).
    mass_iy
        ∫z² dA of the rotary inertia about y, density times this, length⁴; iy by default (> 0).
    mass_iz
        ∫y² dA of the rotary inertia about z, density times this, length⁴; iz by default (> 0).

    """

    _form = "Section"
    _tag = "kind"
    kind: ClassVar[Literal["general"]] = "general"

    area: float
    iy: float
    iz: float
    j: float | None = None
    ky: float | None = None
    kz: float | None = None
    mass_iy: float | None = None
    mass_iz: float | None = None


Section: TypeAlias = Circle | Tube | Rectangle | Ellipse | GeneralSection
"""A cross-section, centred on the beam's axis, with its principal axes along y and z.

Second moments have the names of the axes about which they bend: ``iy`` = ∫z² dA, ``iz`` = ∫y² dA. Shear
factors have those of their forces: ``ky`` belongs to a shear force along y.
"""
