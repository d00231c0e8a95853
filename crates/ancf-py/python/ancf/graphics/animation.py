"""Films of motions, ways of equilibria and shapes of modes."""

from __future__ import annotations

from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.lines import COLOURS, Lines, filmed, shaking, told, whole, with_unit
from ancf.plot import style
from ancf.shape import GREY, Canvas, View, arms, arms_at, axes_of, body_colours, legend, strokes

if TYPE_CHECKING:
    import os
    from collections.abc import Iterator

    from matplotlib.animation import FuncAnimation

    from ancf.record import Array
    from ancf.result import Result

FILM = 5.0
"""Seconds that a film takes if no speed is given."""


def frames(result: Result, speed: float | None, fps: int) -> tuple[list[int], float]:
    """Frames that a film shows one after the other, and by how much it is faster than the motion."""
    if result.kind != "dynamics":
        return [round(row) for row in np.linspace(0, len(result.frames) - 1, round(FILM * fps))], 1.0
    time = result.frames
    lasted = float(time[-1] - time[0])
    speed = lasted / FILM if speed is None else speed
    if not 0 < speed < np.inf:
        msg = f"speed: found {speed}, wanted a number > 0, or None"
        raise ValueError(msg)
    count = max(2, round(lasted / speed * fps) + 1)
    at = np.linspace(time[0], time[-1], count)
    after = np.searchsorted(time, at).clip(1, len(time) - 1)
    nearer = at - time[after - 1] < time[after] - at
    return [int(row) for row in np.where(nearer, after - 1, after)], speed


def animate(
    result: Result,
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
    """See `Result.animate`."""
    import matplotlib.pyplot as plt
    from matplotlib.animation import FuncAnimation

    whole("fps", fps, 1)
    filmed(result)
    if save is not None:
        check(Path(save))
    lines = Lines(result, parts)
    film = (
        Vibration(result, lines, mode, scale, fps)
        if lines.modal
        else Motion(result, lines, speed, scale, fps)
    )
    step = max(1, len(film.frames) // 60)
    every = [lines.reach(0 if lines.modal else i, film.places(i)) for i in film.frames[::step]]
    extent = np.concatenate([*every, lines.rest])
    view = View.of(plane, extent)
    with style():
        ax: Canvas = axes_of(view, unit=result.field_units.get("position"))
        if reference:
            strokes(ax, view, lines, lines.rest, [GREY] * len(lines.bodies), {"linewidth": 1, "zorder": 1})
        drawn = strokes(ax, view, lines, film.places(film.frames[0]), body_colours(lines, None), {})
        links = arms(ax, view, lines, 0, film.places(film.frames[0]), {})
        view.fit(ax, extent)
        if 1 < len(lines.bodies) <= len(COLOURS):
            legend(ax, lines)
        stamp = ax.set_title(film.told(film.frames[0]), loc="left", family="monospace", fontsize="medium")
        settle(ax)

    def show(frame: int) -> list[Any]:
        places = film.places(frame)
        ways = [view.seen(places[stations]).T for stations in lines.bodies.values()]
        if not lines.modal:
            ways.append(arms_at(view, lines, frame, places))
        for line, way in zip([*drawn, links], ways, strict=False):
            (line.set_data_3d if view.spatial else line.set_data)(*way)
        stamp.set_text(film.told(frame))
        return [*drawn, links, stamp]

    made = FuncAnimation(ax.figure, show, frames=film.frames, interval=1000 / fps)
    if save is not None:
        write(made, Path(save), fps)
    if "inline" in plt.get_backend():
        # A notebook would show the first frame below the film.
        plt.close(ax.figure)
    return made


def settle(ax: Canvas) -> None:
    """Find the layout and the limits once: they would be found anew for each frame, and might change."""
    ax.figure.draw_without_rendering()
    ax.figure.set_layout_engine("none")
    if not hasattr(ax, "get_zlim"):
        ax.set(xlim=ax.get_xlim(), ylim=ax.get_ylim())
        ax.set_adjustable("box")


class Motion:
    """Rows of a result one after the other."""

    def __init__(
        self, result: Result, lines: Lines, speed: float | None, scale: float | None, fps: int
    ) -> None:
        """The rows that a film with so many frames a second shows."""
        self._result, self._lines, self._scale = result, lines, scale
        self.frames, self._speed = frames(result, speed, fps)

    def places(self, frame: int) -> Array:
        """Positions in a frame, `[station, 3]`."""
        return self._lines.places(frame, self._scale)

    def told(self, frame: int) -> str:
        """What stands above it."""
        if self._result.kind != "dynamics":
            return told(self._result, frame)
        time = self._result.frames
        decimals = max(0, 2 - int(np.floor(np.log10(time[-1])))) if time[-1] > 0 else 0
        words = with_unit(f"t = {time[frame]:.{decimals}f}", self._result.field_units.get("time"), " ")
        return words + (f"   speed {self._speed:.3g}" if self._speed != 1 else "")


class Vibration:
    """A shape that swings to and fro, twice."""

    def __init__(self, result: Result, lines: Lines, mode: int | None, scale: float | None, fps: int) -> None:
        """The shape of a row, by default of the lowest mode that is no rigid motion."""
        row = shaking(result)[0] if mode is None else mode
        count = len(result.frames)
        if not -count <= row < count:
            msg = f"mode: found {row}, wanted less than {count}"
            raise IndexError(msg)
        self._lines, self._row, self._words = lines, row % count, told(result, row % count)
        self._scale = lines.scale(self._row) if scale is None else scale
        self.frames = list(range(2 * fps))
        self._angles = 2 * np.pi * np.arange(len(self.frames)) / fps

    def places(self, frame: int) -> Array:
        """Positions in a frame, `[station, 3]`."""
        return self._lines.places(self._row, self._scale * float(np.sin(self._angles[frame])))

    def told(self, frame: int) -> str:
        """What stands above it."""
        return self._words


def check(path: Path) -> None:
    """Refuse a file that cannot be written, before work is done for it."""
    from matplotlib.animation import FFMpegWriter

    if path.suffix.lower() not in {".gif", ".mp4", ".html"}:
        msg = f"save: found {str(path)!r}, wanted a name that ends in .gif, .mp4 or .html"
        raise ValueError(msg)
    with ffmpeg():
        if path.suffix.lower() == ".mp4" and not FFMpegWriter.isAvailable():
            msg = f"{path}: needs ffmpeg, which was not found; save a .gif, or pip install imageio-ffmpeg"
            raise RuntimeError(msg)


def write(film: FuncAnimation, path: Path, fps: int) -> None:
    """Write a film as a GIF, by Pillow, or as an MP4, by ffmpeg, or as a page with buttons."""
    from matplotlib.animation import FFMpegWriter, PillowWriter

    kind = path.suffix.lower()
    if kind == ".gif":
        film.save(path, writer=PillowWriter(fps=fps))
    elif kind == ".mp4":
        with ffmpeg():
            film.save(path, writer=FFMpegWriter(fps=fps))
    else:
        path.write_text(film.to_jshtml(fps=fps), encoding="utf-8")


@contextmanager
def ffmpeg() -> Iterator[None]:
    """The program that writes MP4: that of imageio-ffmpeg if it is installed, otherwise the system's."""
    import matplotlib.pyplot as plt

    settings: dict[Any, Any] = {}
    if find_spec("imageio_ffmpeg"):
        from imageio_ffmpeg import get_ffmpeg_exe  # type: ignore[import-untyped]

        settings = {"animation.ffmpeg_path": get_ffmpeg_exe()}
    with plt.rc_context(settings):
        yield
