"""A scene shown: in a window, in a notebook, as a picture, as a film."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ancf.animation import frames
from ancf.lines import told
from ancf.scene import Scene
from ancf.shape import View, limits

if TYPE_CHECKING:
    import os

    from ancf.record import Array
    from ancf.result import Result

FPS = 25
"""Frames of a film in a second."""


LEAST = 1 / 400
"""Thickness of the thinnest body that is shown, over the size of the model."""


def show(
    result: Result,
    frame: int,
    *,
    time: float | None,
    color: str | None,
    animate: bool,
    screenshot: str | os.PathLike[str] | None,
    movie: str | os.PathLike[str] | None,
    seconds: float,
    labels: bool,
    view: str | None,
    size: tuple[int, int],
    scale: float | None,
    parts: int,
    sides: int,
) -> object:
    """See `Result.show`."""
    mapped = None if color is None or painted(color) else color
    scene = Scene(result, color=mapped, scale=scale, parts=parts, sides=sides, least=LEAST)
    stage = Stage(
        scene,
        scene.row(frame, time),
        view=view,
        size=size,
        labels=labels,
        hidden=screenshot is not None or movie is not None,
        paint=None if mapped else color,
        moving=animate or movie is not None,
    )
    if screenshot is not None:
        stage.picture(screenshot)
    if movie is not None:
        stage.film(movie, seconds)
    if screenshot is None and movie is None:
        return stage.open(slider=animate)
    stage.plotter.close()
    return None


def painted(color: str) -> bool:
    """Whether it is the name of a colour, not of a quantity."""
    import pyvista as pv

    try:
        pv.Color(color)
    except ValueError:
        return False
    return True


class Stage:
    """A plotter of PyVista with a scene on it."""

    def __init__(
        self,
        scene: Scene,
        row: int,
        *,
        view: str | None = None,
        size: tuple[int, int] = (1024, 768),
        labels: bool = False,
        hidden: bool = False,
        paint: str | None = None,
        moving: bool = False,
    ) -> None:
        """Put a scene up as it is in a row; `hidden` if it is only for a file.

        Where it is `moving`, the camera and the colours have all rows in view.
        """
        import pyvista as pv

        self.scene, self.row = scene, row
        self.mesh = scene.mesh(row)
        self.plotter = pv.Plotter(off_screen=hidden or None, window_size=list(size))
        self.plotter.set_background("white")
        self.plotter.enable_anti_aliasing("ssaa")
        if scene.values is not None:
            between = limits(scene.values if moving else scene.values[row])
            self.plotter.add_mesh(
                self.mesh,
                scalars=scene.color,
                smooth_shading=True,
                clim=list(between),
                cmap="coolwarm" if between[0] == -between[1] else "viridis",
                nan_color="#9a9a9a",
                scalar_bar_args={"color": "black", "fmt": "%.3g", "n_labels": 5},
            )
        elif paint is not None:
            self.plotter.add_mesh(self.mesh, color=paint, smooth_shading=True)
        else:
            self.plotter.add_mesh(self.mesh, scalars="shade", rgb=True, smooth_shading=True)
        self.stamp = self.plotter.add_text(told(scene.result, row), "upper_left", 10, "black")
        self.plotter.add_axes(color="black")  # type: ignore[call-arg]
        if labels:
            self._label()
        self._look(view, moving)

    def picture(self, path: str | os.PathLike[str]) -> None:
        """Write what is seen."""
        self.plotter.screenshot(str(path))

    def film(self, path: str | os.PathLike[str], seconds: float) -> None:
        """Write a film, `.gif` or `.mp4`."""
        kind = Path(path).suffix.lower()
        needed = {".gif": ["imageio"], ".mp4": ["imageio", "imageio_ffmpeg"]}
        if kind not in needed:
            msg = f"movie: found {str(path)!r}, wanted a name that ends in .gif or .mp4"
            raise ValueError(msg)
        missing = [name.replace("_", "-") for name in needed[kind] if find_spec(name) is None]
        if missing:
            msg = f"{path}: needs {' and '.join(missing)}: pip install {' '.join(missing)}"
            raise RuntimeError(msg)
        if kind == ".gif":
            self.plotter.open_gif(str(path), fps=FPS, loop=0)
        else:
            self.plotter.open_movie(str(path), framerate=FPS)
        for row, scale in self._frames(seconds):
            self.to(row, scale)
            self.plotter.write_frame()

    def open(self, *, slider: bool) -> object:
        """Show it in a window, or in a notebook as a picture that can be turned if trame is there."""
        turned = find_spec("trame") is not None
        if slider and (turned or not self.plotter.notebook):
            last = len(self.scene.result) - 1
            self.plotter.add_slider_widget(
                lambda value: self.to(round(value)), [0, last], self.row, fmt="%.0f", color="black"
            )
        return self.plotter.show(jupyter_backend="trame" if turned else "static")

    def to(self, row: int, scale: float | None = None) -> None:
        """Go to another row."""
        self.row = row
        self.scene.move(self.mesh, row, scale)
        self.stamp.set_text("upper_left", told(self.scene.result, row))
        self.plotter.render()

    def _frames(self, seconds: float) -> list[tuple[int, float | None]]:
        scene = self.scene
        if scene.lines.modal:
            count = max(2, round(FPS * seconds / max(1, round(seconds))))
            scale = scene.lines.scale(self.row) if scene.scale is None else scene.scale
            swing = scale * np.sin(2 * np.pi * np.arange(count) / count)
            return [(self.row, float(x)) for x in swing] * max(1, round(seconds))
        result = scene.result
        if result.kind != "dynamics":
            at = np.linspace(0, len(result) - 1, max(2, round(seconds * FPS)))
            return [(round(row), None) for row in at]
        speed = float(result.time[-1] - result.time[0]) / seconds
        return [(row, None) for row in frames(result, speed, FPS)[0]]

    def _seen(self, moving: bool) -> Array:
        """Points that the camera is to have in view."""
        scene, count = self.scene, len(self.scene.result)
        if scene.lines.modal or not moving:
            return np.asarray(self.mesh.points)
        every = range(0, count, max(1, count // 60))
        return np.concatenate([scene.points(row) for row in (*every, count - 1)])

    def _look(self, view: str | None, moving: bool) -> None:
        points = self._seen(moving)
        flat = View.of(None, self.scene.lines.path if moving else self.scene.lines.places(self.row))
        tilted = view is None and not flat.spatial
        if view not in {None, "iso", "xy", "xz", "yz"}:
            msg = f"view: found {view!r}, wanted 'xy', 'xz', 'yz' or 'iso'"
            raise ValueError(msg)
        self.plotter.camera_position = flat.names if tilted else view or "iso"
        if tilted:
            # Nearly onto the plane, but so that bodies are seen to be thick.
            self.plotter.camera.azimuth = 20
            self.plotter.camera.elevation = 15
        low, high = points.min(0), points.max(0)
        self.plotter.reset_camera(bounds=[float(x) for pair in zip(low, high, strict=True) for x in pair])
        self.plotter.camera.zoom(1.15)

    def _label(self) -> None:
        named = self.scene.joints(self.row)
        if named:
            self.plotter.add_point_labels(
                np.array(list(named.values())),
                list(named),
                font_size=14,
                shape=None,
                text_color="black",
                always_visible=True,
            )
