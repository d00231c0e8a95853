"""Places on bodies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from ancf.part import Part, Vector

if TYPE_CHECKING:
    from ancf.model.places import Place

__all__ = ["Axis", "Frame", "Point"]


def _place(body: str, at: Literal["start", "center", "end"] | float | Vector, offset: Vector | None) -> Place:
    from ancf.model.places import Place

    return Place(body=body, at=at, offset=offset)


class Axis(Part):
    """A body with an axis, on which there are places."""

    __slots__ = ()

    name: str

    @property
    def start(self) -> Place:
        """The place where the axis starts."""
        return _place(self.name, "start", None)

    @property
    def end(self) -> Place:
        """The place where the axis ends."""
        return _place(self.name, "end", None)

    def at(self, at: Literal["start", "center", "end"] | float, *, offset: Vector | None = None) -> Place:
        """The place at an arc length from the start, or at a named point.

        Parameters
        ----------
        at
            Arc length in the undeformed state, length, or ``"start"``, ``"center"``, ``"end"``.
        offset
            A rigid arm from there, fixed to the section, in the global frame at the start, length.

        """
        return _place(self.name, at, offset)


class Frame(Part):
    """A rigid body, every point of which is a place."""

    __slots__ = ()

    name: str

    def at(self, at: Literal["center"] | Vector = "center", *, offset: Vector | None = None) -> Place:
        """The place at a point, or at the centre of mass.

        Parameters
        ----------
        at
            A point, where it is at the start, length, or ``"center"``.
        offset
            A rigid arm from there, in the global frame at the start, length.

        """
        return _place(self.name, at, offset)


class Point(Part):
    """A body that is a point."""

    __slots__ = ()

    name: str

    def at(self, at: Literal["center"] = "center", *, offset: Vector | None = None) -> Place:
        """The place of the point.

        Parameters
        ----------
        at
            ``"center"``, the only place it has.
        offset
            A rigid arm from there, in the global frame at the start, length.

        """
        return _place(self.name, at, offset)
