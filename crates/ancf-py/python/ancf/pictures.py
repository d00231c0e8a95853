"""The pictures that a result can give of itself."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, cast, overload

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable

    from matplotlib.animation import FuncAnimation
    from matplotlib.axes import Axes
    from pyvista import PolyData

    from ancf.plot import Grid
    from ancf.result import Result


class Pictures:
    """Pictures of a result: curves, shapes and films by matplotlib, bodies in space by PyVista."""

    @overload
    def plot(self) -> Grid: ...

    @overload
    def plot(
        self,
        *names: str,
        x: str | None = None,
        ax: Axes | None = None,
        subplots: Literal[False] = False,
        **line: object,
    ) -> Axes: ...

    @overload
    def plot(
        self, *names: str, x: str | None = None, ax: None = None, subplots: Literal[True], **line: object
    ) -> Grid: ...

    @overload
    def plot(
        self,
        *names: str,
        x: str | None = None,
        ax: Axes | None = None,
        subplots: bool = False,
        **line: object,
    ) -> Axes | Grid: ...

    def plot(
        self,
        *names: str,
        x: str | None = None,
        ax: Axes | None = None,
        subplots: bool = False,
        **line: object,
    ) -> Axes | Grid:
        """Draw columns over time, or the load factor over what moves, or dots over the number of the mode.

        Returns the axes, several with `subplots` or without names.

        Parameters
        ----------
        *names
            Columns; probes, of which positions are drawn; joints; vectors such as `tip.velocity`; `energy`.
            Without any, an overview: how far probes moved since the first row, and energies; or all modes.
        x
            The column to draw over, instead of time, load factor or mode.
        ax
            The axes to draw in, instead of new ones.
        subplots
            Whether each name has axes of its own, or each column of a single name.
        **line
            Properties of the lines, such as `linestyle="--"`.

        """
        from ancf.plot import plot

        return plot(cast("Result", self), *names, x=x, ax=ax, subplots=subplots, **line)

    def plot_shape(
        self,
        frame: int | Iterable[int] = -1,
        *,
        time: float | Iterable[float] | None = None,
        plane: str | None = None,
        color: str | None = None,
        scale: float | None = None,
        reference: bool = True,
        parts: int = 8,
        ax: Axes | None = None,
        **line: object,
    ) -> Axes:
        """Draw the bodies as they are in a row, or in several, the earlier the fainter.

        Parameters
        ----------
        frame
            Number of a row or of several, from the end if negative; modes are rows too. Of a result of
            `ancf.load`, of the states that were kept, `Result.frames`.
        time
            A time or several, instead of `frame`; the states next to them are drawn.
        plane
            Two letters, the first to the right, such as `xz`, or `3d`; by default as the model extends.
        color
            A colour, or what to colour by: `N`, `Qy`, `Qz`, `T`, `My`, `Mz`, `displacement`, `velocity`,
            `acceleration`, or components such as `displacement.y`.
        scale
            By what to multiply deflections: by default 1, of modes so that they are well seen.
        reference
            Whether the reference configuration is drawn too, in grey.
        parts
            Points that are drawn in each element.
        ax
            The axes to draw in, instead of new ones.
        **line
            Properties of the lines, such as `linewidth=3`.

        """
        from ancf.shape import plot_shape

        return plot_shape(
            cast("Result", self),
            frame,
            time=time,
            plane=plane,
            color=color,
            scale=scale,
            reference=reference,
            parts=parts,
            ax=ax,
            **line,
        )

    def plot_modes(
        self,
        count: int = 6,
        *,
        rigid: bool = False,
        plane: str | None = None,
        scale: float | None = None,
        parts: int = 8,
    ) -> Grid:
        """Draw the first modes, or shapes of buckling, each in axes of its own, which are returned.

        Parameters
        ----------
        count
            How many.
        rigid
            Whether rigid motions, of frequency zero, are among them.
        plane
            Two letters, the first to the right, such as `xz`, or `3d`; by default as the modes extend. A
            straight line is shown in the plane in which it deflects most, of each mode its own.
        scale
            By what to multiply the shapes; by default so that they are well seen.
        parts
            Points that are drawn in each element.

        """
        from ancf.shape import plot_modes

        return plot_modes(cast("Result", self), count, rigid=rigid, plane=plane, scale=scale, parts=parts)

    def animate(
        self,
        *,
        speed: float | None = None,
        fps: int = 25,
        mode: int | None = None,
        plane: str | None = None,
        scale: float | None = None,
        reference: bool = True,
        parts: int = 8,
        save: str | os.PathLike[str] | None = None,
    ) -> FuncAnimation:
        """Make a film of a motion, of the way of equilibria, or of a mode.

        In a notebook, `IPython.display.HTML(result.animate().to_jshtml())` shows it; in a program,
        `matplotlib.pyplot.show()` does, as long as what is returned is kept.

        Parameters
        ----------
        speed
            Time of the model that passes in a second: 1 is real time. By default a film takes 5 seconds.
        fps
            Frames in a second.
        mode
            Number of the row of the mode that is shown, by default the first that is no rigid motion.
        plane
            Two letters, the first to the right, such as `xz`, or `3d`; by default as the motion extends.
        scale
            By what to multiply deflections: by default 1, of modes so that they are well seen.
        reference
            Whether the reference configuration is drawn too, in grey.
        parts
            Points that are drawn in each element.
        save
            A file to write: `.gif`, `.mp4`, which needs ffmpeg, or `.html`, a page with buttons.

        """
        from ancf.animation import animate

        return animate(
            cast("Result", self),
            speed=speed,
            fps=fps,
            mode=mode,
            plane=plane,
            scale=scale,
            reference=reference,
            parts=parts,
            save=save,
        )

    def scene(
        self,
        frame: int = -1,
        *,
        time: float | None = None,
        color: str | None = None,
        scale: float | None = None,
        parts: int = 8,
        sides: int = 24,
    ) -> PolyData:
        """The surfaces of all bodies in a row, for PyVista: sections swept along beams and cables.

        Each body is closed. Cells have the number of their `body`, points the arc length `s` and what
        `color` names. Rigid bodies, whose outlines a model does not know, are boxes in the proportions of
        their inertia with arms to their joints, masses are balls. In modes, sections do not twist.

        Parameters
        ----------
        frame
            Number of the row, from the end if negative.
        time
            A time, instead of `frame`; the state next to it is taken.
        color
            What points have data of, as in `plot_shape`.
        scale
            By what to multiply deflections: by default 1, of modes so that they are well seen.
        parts
            Sections in each element.
        sides
            Sides of the polygon that stands for a round section.

        """
        from ancf.scene import Scene

        scene = Scene(cast("Result", self), color=color, scale=scale, parts=parts, sides=sides)
        return scene.mesh(scene.row(frame, time))

    def show(
        self,
        frame: int = -1,
        *,
        time: float | None = None,
        color: str | None = None,
        animate: bool = False,
        screenshot: str | os.PathLike[str] | None = None,
        movie: str | os.PathLike[str] | None = None,
        seconds: float = 5.0,
        labels: bool = False,
        view: str | None = None,
        size: tuple[int, int] = (1024, 768),
        scale: float | None = None,
        parts: int = 8,
        sides: int = 24,
    ) -> object:
        """Show the bodies in space, in a window or in a notebook, or write a picture or a film of them.

        What is thinner than a 400th of the model is drawn that thick, so that it is seen.
        In notebooks, pictures can be turned if there is trame (`pip install 'pyvista[jupyter]'`), and are
        still otherwise. Returns what PyVista does, which a notebook displays.

        Parameters
        ----------
        frame
            Number of the row, from the end if negative.
        time
            A time, instead of `frame`; the state next to it is shown.
        color
            A colour, or what to colour by, as in `plot_shape`.
        animate
            Whether a slider goes through the rows.
        screenshot
            A picture to write, such as `x.png`, or `x.html`, a page in which it can be turned; nothing is
            shown then.
        movie
            A film to write, `.gif` or `.mp4`; nothing is shown then. Of a mode, it swings to and fro.
        seconds
            What a film takes.
        labels
            Whether joints are named.
        view
            `xy`, `xz`, `yz` or `iso`; by default as the model extends.
        size
            Width and height, pixels.
        scale
            By what to multiply deflections: by default 1, of modes so that they are well seen.
        parts
            Sections in each element.
        sides
            Sides of the polygon that stands for a round section.

        """
        from ancf.stage import show

        return show(
            cast("Result", self),
            frame,
            time=time,
            color=color,
            animate=animate,
            screenshot=screenshot,
            movie=movie,
            seconds=seconds,
            labels=labels,
            view=view,
            size=size,
            scale=scale,
            parts=parts,
            sides=sides,
        )
