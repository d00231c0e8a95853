"""Materials."""

# Written by `cargo xtask schema` from the types of the program: change those.

from dataclasses import dataclass
from typing import Literal, TypeAlias

from ancf.part import Part, Shared

__all__ = ["Damping", "Material", "MaterialLaw"]


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Damping(Part):
    """What dissipates in a material.

    Attributes
    ----------
    mass
        Rate α of the mass-proportional damping, the force −α v per mass. 1/time (>= 0). Default: ``0.0``.
    strain
        Retardation time τ of Kelvin and Voigt: stresses are those of the strain E + τ dE/dt. Time (>= 0).
        Default: ``0.0``.

    """

    _form = "Damping"

    mass: float | None = None
    strain: float | None = None


MaterialLaw: TypeAlias = Literal["st_venant_kirchhoff", "neo_hookean"]
"""How stress follows strain.

* ``"st_venant_kirchhoff"``: St. Venant and Kirchhoff: ½(λ tr² E + 2G E:E) of Green's strain.
* ``"neo_hookean"``: Compressible neo-Hookean: ½G (tr C − 3) − G ln J + ½λ ln² J; for the continuum
  formulation.
"""


@dataclass(kw_only=True, slots=True, eq=False, repr=False)
class Material(Shared):
    """An isotropic elastic material with damping.

    Attributes
    ----------
    name
        Key in the model's table, for a part that is given in the place of its name; found by itself if left
        out.
    density
        Density ρ, mass/volume (> 0).
    young
        Young's modulus E, force/area (> 0).
    damping
        What dissipates. Default: ``Damping(mass=0.0, strain=0.0)``.
    law
        How stress follows strain. One of ``"st_venant_kirchhoff"``, ``"neo_hookean"``. Default:
        ``"st_venant_kirchhoff"``.
    poisson
        Poisson's ratio ν, −1 < ν < 0.5; 0 by default (> -1, < 0.5).

    """

    _form = "Material"

    density: float
    young: float
    damping: Damping | None = None
    law: MaterialLaw | None = None
    poisson: float | None = None
