"""A scene shown: in a window, in a notebook, as a picture, as a film."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ancf.animation import frames
from ancf.lines import filmed, told
from ancf.scene import Scene
from ancf.shape import View, limits, named

if TYPE_CHECKING:
    import os

    from ancf.record import Array
    from ancf.result import Result

EDGE = 0.86
"""How much of a picture is filled."""

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
    if not 0 < seconds < np.inf:
        msg = f"seconds: found {seconds}, wanted a number > 0"
        raise ValueError(msg)
    if movie is not None:
        filmed(result)
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


def can_turn() -> bool:
    """Whether pictures in notebooks can be turned: since 0.49 PyVista has a package of its own for that."""
    import pyvista as pv

    new = tuple(int(part) for part in pv.__version__.split(".")[:2]) >= (0, 49)
    return find_spec("trame_pyvista" if new else "trame") is not None


def painted(color: str) -> bool:
    """Whether it is the name of a colour, not of a quantity."""
    import pyvista as pv

    try:
        pv.Color(color)
    except ValueError:
        return False
    return True


LIGHT = {"smooth_shading": True, "ambient": 0.35, "diffuse": 0.75, "specular": 0.1}
"""How surfaces reflect."""

BAR = {
    "vertical": True,
    "position_x": 0.88,
    "position_y": 0.2,
    "height": 0.6,
    "width": 0.06,
    "n_labels": 5,
    "fmt": "%.3g",
    "color": "black",
    "title_font_size": 18,
    "label_font_size": 14,
}
"""The scale of colours."""


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
        # PyVista decorates its methods in ways that types do not follow.
        self.plotter = cast("Any", pv.Plotter(off_screen=hidden or None, window_size=list(size)))
        self.plotter.set_background("white")
        self.plotter.enable_anti_aliasing("ssaa")
        self.plotter.enable_parallel_projection()
        self.plotter.add_mesh(self.mesh, **self._paint(paint, moving), **LIGHT)
        words = told(scene.result, row)
        self.stamp = self.plotter.add_text(words, position="upper_left", font_size=10, color="black")
        self.plotter.add_axes(color="black")
        if labels:
            self._label()
        self._look(view, moving)

    def _paint(self, paint: str | None, moving: bool) -> dict[str, Any]:
        """Colours, as what adds a mesh to a plotter wants to know them."""
        if paint is not None:
            return {"color": paint}
        if self.scene.values is None:
            return {"scalars": "shade", "rgb": True}
        least, greatest = limits(self.scene.values if moving else self.scene.values[self.row])
        return {
            "scalars": self.scene.color,
            "clim": [least, greatest],
            "cmap": "coolwarm" if least == -greatest else "viridis",
            "nan_color": "#b0b0b0",
            "scalar_bar_args": {"title": f"{named(self.scene.result, self.scene.color)}\n", **BAR},
        }

    def picture(self, path: str | os.PathLike[str]) -> None:
        """Write what is seen, or a page in which it can be turned."""
        if Path(path).suffix.lower() != ".html":
            self.plotter.screenshot(str(path))
        elif can_turn():
            # Since 0.49 what needs trame is under a name of its own.
            getattr(self.plotter, "trame", self.plotter).export_html(str(path))
        else:
            msg = f"{path}: needs trame: pip install 'pyvista[jupyter]'"
            raise RuntimeError(msg)

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
        import pyvista as pv

        notebook = bool(self.plotter.notebook)
        turned = can_turn() and pv.global_theme.jupyter_backend not in {"static", "none"}
        if slider and (turned or not notebook):
            last = len(self.scene.result.frames) - 1
            self.plotter.add_slider_widget(
                lambda value: self.to(round(value)), [0, last], value=self.row, fmt="%.0f", color="black"
            )
        return self.plotter.show(**({} if turned or not notebook else {"jupyter_backend": "static"}))

    def to(self, row: int, scale: float | None = None) -> None:
        """Go to another row."""
        self.row = row
        self.scene.move(self.mesh, row, scale)
        self.stamp.set_text("upper_left", told(self.scene.result, row))

    def _frames(self, seconds: float) -> list[tuple[int, float | None]]:
        scene = self.scene
        if scene.lines.modal:
            count = max(2, round(FPS * seconds / max(1, round(seconds))))
            scale = scene.lines.scale(self.row) if scene.scale is None else scene.scale
            swing = scale * np.sin(2 * np.pi * np.arange(count) / count)
            return [(self.row, x) for x in swing.tolist()] * max(1, round(seconds))
        result = scene.result
        if result.kind != "dynamics":
            at = np.linspace(0, len(result.frames) - 1, max(2, round(seconds * FPS)))
            return [(round(row), None) for row in at]
        speed = float(result.frames[-1] - result.frames[0]) / seconds
        return [(row, None) for row in frames(result, speed, FPS)[0]]

    def _seen(self, moving: bool) -> Array:
        """Points that the camera is to have in view."""
        scene, count = self.scene, len(self.scene.result.frames)
        if scene.lines.modal or not moving:
            return np.asarray(self.mesh.points)
        every = range(0, count, max(1, count // 60))
        return np.concatenate([scene.points(row) for row in (*every, count - 1)])

    def _look(self, view: str | None, moving: bool) -> None:
        """Turn the camera and have everything in view, beside the scale of colours."""
        if view not in {None, "iso", "xy", "xz", "yz"}:
            msg = f"view: found {view!r}, wanted 'xy', 'xz', 'yz' or 'iso'"
            raise ValueError(msg)
        flat = View.of(None, self.scene.lines.path if moving else self.scene.lines.places(self.row))
        camera = self.plotter.camera
        self.plotter.camera_position = view or ("iso" if flat.spatial else flat.names)
        if view is None and not flat.spatial:
            # Nearly onto the plane, but so that bodies are seen to be thick.
            camera.azimuth, camera.elevation = 20, 15
        points = self._seen(moving)
        forward = np.asarray(camera.direction)
        right = np.cross(forward, camera.up)
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(right, forward), forward])
        low, high = (points @ axes.T).min(0), (points @ axes.T).max(0)
        half, middle = (high - low) / 2, (high + low) / 2
        wide, high_pixels = self.plotter.window_size
        room = 0.74 if self.scene.values is not None else EDGE
        scale = max(half[1] / EDGE, half[0] / room * high_pixels / wide) or 1.0
        middle[0] += (EDGE - room) * scale * wide / high_pixels
        camera.focal_point = middle @ axes
        camera.position = middle @ axes - forward * 4 * (scale + half[2])
        camera.parallel_scale = scale
        self.plotter.reset_camera_clipping_range()

    def _label(self) -> None:
        """Name the joints, where they are in the row."""
        named = self.scene.joints(self.row)
        if named:
            look = {"font_size": 13, "bold": False, "text_color": "black", "shape_color": "white"}
            places = np.array(list(named.values()))
            self.plotter.add_point_labels(places, list(named), shape_opacity=0.7, always_visible=True, **look)
