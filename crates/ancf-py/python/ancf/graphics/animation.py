"""Animations of motions, equilibrium paths and mode shapes by matplotlib."""

from __future__ import annotations

from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ancf.display.numbers import with_unit
from ancf.graphics.artists import (
    arm_coordinates,
    body_colours,
    draw_arms,
    draw_legend,
    draw_lines,
    draw_reference,
)
from ancf.graphics.frames import (
    elastic_modes,
    frame_label,
    frames_of_animation,
    require_frames,
    require_int,
)
from ancf.graphics.lines import Lines, drawn_parts
from ancf.graphics.style import style
from ancf.graphics.view import Canvas, View
from ancf.record.result_data import ResultData

if TYPE_CHECKING:
    import os
    from collections.abc import Iterator

    from matplotlib.animation import FuncAnimation

    from ancf.record.columns import Array

MAX_EXTENT_FRAMES = 60
"""Maximum number of frames from which the limits of the axes are computed."""


class Animations(ResultData):
    """Animations of a result."""

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
        """Animate a motion, an equilibrium path, or a mode. Points of complex modes move on ellipses.

        In a notebook, `IPython.display.HTML(result.animate().to_jshtml())` shows the animation; in a program,
        `matplotlib.pyplot.show()` does, as long as a reference to the returned object exists.

        Parameters
        ----------
        speed
            Ratio of model time to playback time: 1 is real time. By default an animation takes 5 seconds.
        fps
            Frames per second.
        mode
            Row of the mode; by default the first elastic mode.
        plane
            Two letters such as `xz`, the first to the right, or `3d`; by default the plane of the motion.
        scale
            Factor of deflections; by default 1, for modes chosen automatically.
        reference
            True to plot the reference configuration in grey.
        parts
            Number of segments per element.
        save
            File to write: `.gif`, `.mp4`, which needs ffmpeg, or `.html`, a page with buttons.

        """
        import matplotlib.pyplot as plt
        from matplotlib.animation import FuncAnimation

        require_int("fps", fps, 1)
        require_frames(self)
        if save is not None:
            _check_file(Path(save))
        lines = Lines(self, drawn_parts(self, parts))
        film = (
            ModeSequence(self, lines, mode, scale, fps)
            if lines.modal
            else RowSequence(self, lines, speed, scale, fps)
        )
        extent = _extent(lines, film)
        view = View.of(plane, extent)
        first = film.frames[0]
        with style():
            ax: Canvas = view.axes(unit=self.field_units.get("position"))
            if reference:
                draw_reference(ax, view, lines, lines.reference)
            drawn = draw_lines(ax, view, lines, film.positions(first), body_colours(lines, None), {})
            arms = draw_arms(ax, view, lines, 0, film.positions(first), {})
            view.fit(ax, extent)
            draw_legend(ax, lines)
            title = ax.set_title(film.label(first), loc="left", family="monospace", fontsize="medium")
            _freeze_layout(ax)

        def update(frame: int) -> list[Any]:
            positions = film.positions(frame)
            paths = [path.T for path in lines.polylines(view.coordinates(positions))]
            if not lines.modal:
                paths.append(arm_coordinates(view, lines, frame, positions))
            for line, path in zip([*drawn, arms], paths, strict=False):
                (line.set_data_3d if view.spatial else line.set_data)(*path)
            title.set_text(film.label(frame))
            return [*drawn, arms, title]

        animation = FuncAnimation(ax.figure, update, frames=film.frames, interval=1000 / fps)
        if save is not None:
            _write(animation, Path(save), fps)
        if "inline" in plt.get_backend():
            # A notebook would show the first frame below the animation.
            plt.close(ax.figure)
        return animation


class RowSequence:
    """Frames of a result in order."""

    def __init__(
        self, result: ResultData, lines: Lines, speed: float | None, scale: float | None, fps: int
    ) -> None:
        """Select the frames for a number of frames per second."""
        self._result, self._lines, self._scale = result, lines, scale
        self.frames, self._speed = frames_of_animation(result, speed, fps)

    def positions(self, frame: int) -> Array:
        """Return the positions in a frame, `[station, 3]`."""
        return self._lines.positions(frame, self._scale)

    def label(self, frame: int) -> str:
        """Return the title of a frame."""
        if self._result.kind != "dynamics":
            return frame_label(self._result, frame)
        time = self._result.frames
        decimals = max(0, 2 - int(np.floor(np.log10(time[-1])))) if time[-1] > 0 else 0
        text = with_unit(f"t = {time[frame]:.{decimals}f}", self._result.field_units.get("time"), " ")
        return text + (f"   speed {self._speed:.3g}" if self._speed != 1 else "")


class ModeSequence:
    """Two periods of the vibration of a mode."""

    def __init__(
        self, result: ResultData, lines: Lines, mode: int | None, scale: float | None, fps: int
    ) -> None:
        """Select the mode of a row, by default the lowest elastic mode."""
        row = elastic_modes(result)[0] if mode is None else mode
        count = len(result.frames)
        if not -count <= row < count:
            msg = f"mode: found {row}, expected less than {count}"
            raise IndexError(msg)
        self._lines, self._row = lines, row % count
        self._label = frame_label(result, self._row)
        self._scale = lines.scale(self._row) if scale is None else scale
        self.frames = list(range(2 * fps))
        self._phases = 2 * np.pi * np.arange(len(self.frames)) / fps

    def positions(self, frame: int) -> Array:
        """Return the positions in a frame, `[station, 3]`."""
        return self._lines.phase_positions(self._row, self._scale, float(self._phases[frame]))

    def label(self, frame: int) -> str:
        """Return the title of a frame."""
        return self._label


def _extent(lines: Lines, film: RowSequence | ModeSequence) -> Array:
    """Return the points that determine the limits of the axes."""
    step = max(1, len(film.frames) // MAX_EXTENT_FRAMES)
    every = [lines.points(0 if lines.modal else i, film.positions(i)) for i in film.frames[::step]]
    return np.concatenate([*every, lines.reference])


def _freeze_layout(ax: Canvas) -> None:
    """Compute layout and limits once. Otherwise they would be computed for each frame and could change."""
    ax.figure.draw_without_rendering()
    ax.figure.set_layout_engine("none")
    if not hasattr(ax, "get_zlim"):
        ax.set(xlim=ax.get_xlim(), ylim=ax.get_ylim())
        ax.set_adjustable("box")


def _check_file(path: Path) -> None:
    """Raise an error for a file that cannot be written, before frames are computed."""
    from matplotlib.animation import FFMpegWriter

    if path.suffix.lower() not in {".gif", ".mp4", ".html"}:
        msg = f"save: found {str(path)!r}, expected a name that ends in .gif, .mp4 or .html"
        raise ValueError(msg)
    with _ffmpeg():
        if path.suffix.lower() == ".mp4" and not FFMpegWriter.isAvailable():
            msg = f"{path}: needs ffmpeg, which was not found; save a .gif, or pip install imageio-ffmpeg"
            raise RuntimeError(msg)


def _write(animation: FuncAnimation, path: Path, fps: int) -> None:
    """Write an animation as GIF by Pillow, as MP4 by ffmpeg, or as a page with buttons."""
    from matplotlib.animation import FFMpegWriter, PillowWriter

    kind = path.suffix.lower()
    if kind == ".gif":
        animation.save(path, writer=PillowWriter(fps=fps))
    elif kind == ".mp4":
        with _ffmpeg():
            animation.save(path, writer=FFMpegWriter(fps=fps))
    else:
        path.write_text(animation.to_jshtml(fps=fps), encoding="utf-8")


@contextmanager
def _ffmpeg() -> Iterator[None]:
    """Select the ffmpeg of imageio-ffmpeg if installed, otherwise that of the system."""
    import matplotlib.pyplot as plt

    settings: dict[Any, Any] = {}
    if find_spec("imageio_ffmpeg"):
        from imageio_ffmpeg import get_ffmpeg_exe  # type: ignore[import-untyped]

        settings = {"animation.ffmpeg_path": get_ffmpeg_exe()}
    with plt.rc_context(settings):
        yield
