"""Base classes of bodies: they make the places to which joints and loads attach."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar, Literal

from ancf.model.base.part import Part, Vector
from ancf.model.base.places import EdgeName, EdgePlace, Place

__all__ = ["Axis", "Frame", "Point", "Surface"]


class Axis(Part):
    """A body with an axis on which places are given by arc length."""

    __slots__ = ()
    _places: ClassVar[Sequence[str]] = ("start", "end", "at(s)")

    name: str

    @property
    def start(self) -> Place:
        """Place at the start of the axis."""
        return Place(body=self.name, at="start")

    @property
    def end(self) -> Place:
        """Place at the end of the axis."""
        return Place(body=self.name, at="end")

    def at(self, at: Literal["start", "center", "end"] | float, *, offset: Vector | None = None) -> Place:
        """Return the place at an arc length from the start, or at a named point.

        Parameters
        ----------
        at
            Arc length in the undeformed state, length, or ``"start"``, ``"center"``, ``"end"``.
        offset
            Rigid arm from there, fixed to the section, in the global frame at the start, length.

        """
        return Place(body=self.name, at=at, offset=offset)


class Frame(Part):
    """A rigid body. Each of its points is a place."""

    __slots__ = ()
    _places: ClassVar[Sequence[str]] = ("at()", "at(point)")

    name: str

    def at(self, at: Literal["center"] | Vector = "center", *, offset: Vector | None = None) -> Place:
        """Return the place at a point, or at the centre of mass.

        Parameters
        ----------
        at
            Position of the point at the start, length, or ``"center"``.
        offset
            Rigid arm from there, in the global frame at the start, length.

        """
        return Place(body=self.name, at=at, offset=offset)


class Surface(Part):
    """A shell. Points of its surface and its edges are places."""

    __slots__ = ()
    _places: ClassVar[Sequence[str]] = ("at(u, v)", "edge(name)")

    name: str

    def at(self, u: float = 0.5, v: float = 0.5, *, offset: Vector | None = None) -> Place:
        """Return the place of a point, in the middle by default.

        Parameters
        ----------
        u, v
            Parameters of the point, from 0 to 1.
        offset
            Rigid arm from there, fixed to the surface, in the global frame at the start, length.

        """
        return Place(body=self.name, at=[u, v], offset=offset)

    def edge(self, name: EdgeName) -> Place:
        """Return the place of an edge, for supports.

        Parameters
        ----------
        name
            ``"u_start"``, ``"u_end"``, ``"v_start"`` or ``"v_end"``.

        """
        return Place(body=self.name, at=EdgePlace(edge=name))


class Point(Part):
    """A body without extent."""

    __slots__ = ()
    _places: ClassVar[Sequence[str]] = ("at()",)

    name: str

    def at(self, at: Literal["center"] = "center", *, offset: Vector | None = None) -> Place:
        """Return the place of the point.

        Parameters
        ----------
        at
            ``"center"``, the only place of the body.
        offset
            Rigid arm from there, in the global frame at the start, length.

        """
        return Place(body=self.name, at=at, offset=offset)
