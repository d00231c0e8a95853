"""Scenes in a window, in a notebook, in an image, or in an animation, by PyVista."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ancf.graphics.frames import (
    evenly_spaced_frames,
    frame_label,
    frame_numbers,
    frames_of_animation,
    require_frames,
)
from ancf.graphics.space.scene import Scene
from ancf.graphics.space.symbols import COLOURS, OPACITIES, Symbols
from ancf.graphics.style import colour_map
from ancf.graphics.view import View
from ancf.record.result_data import ResultData

if TYPE_CHECKING:
    import os

    from pyvista import PolyData

    from ancf.record.columns import Array

FILL = 0.86
"""Fraction of the image that the scene fills."""

FILL_BESIDE_BAR = 0.7
"""Fraction of the width that the scene fills beside a colour bar."""

FPS = 25
"""Frames per second of an animation."""

MIN_THICKNESS = 1 / 400
"""Minimum thickness of a body, relative to the size of the model."""

MAX_EXTENT_FRAMES = 60
"""Maximum number of frames from which the camera position is computed."""

LIGHT = {"smooth_shading": True, "ambient": 0.35, "diffuse": 0.75, "specular": 0.1}
"""Reflection of surfaces."""

TITLE_WIDTH = 14
"""Maximum number of characters in a line of the title of a colour bar."""

COLOUR_BAR = {
    "vertical": True,
    "position_x": 0.86,
    "position_y": 0.2,
    "height": 0.55,
    "width": 0.06,
    "n_labels": 5,
    "fmt": "%.3g",
    "color": "black",
    "title_font_size": 16,
    "label_font_size": 14,
}


class Scenes(ResultData):
    """Scenes of a result in space."""

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
        """Return the surfaces of all bodies in a row as a PyVista mesh: sections swept along beams and cables.

        Surfaces of bodies are closed. Cells have the number of their `body`, points have the arc length `s` and the
        quantity `color`. Rigid bodies have their `display` shapes or their contact surface. Without these they are
        boxes with the proportions of their inertia and arms to their joints. Point masses are spheres. In modes,
        sections do not twist.

        Parameters
        ----------
        frame
            Number of the row, from the end if negative.
        time
            A time, instead of `frame`; the closest state is used.
        color
            Quantity of the points, as in `plot_shape`.
        scale
            Factor of deflections; by default 1, for modes chosen automatically.
        parts
            Number of sections per element.
        sides
            Number of sides of a round section.

        """
        scene = Scene(self, color=color, scale=scale, parts=parts, sides=sides)
        return scene.mesh(frame_numbers(self, frame, time)[0])

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
        symbols: bool = True,
        view: str | None = None,
        size: tuple[int, int] = (1024, 768),
        scale: float | None = None,
        parts: int = 8,
        sides: int = 24,
    ) -> object:
        """Show the bodies in space in a window or a notebook, or write an image or an animation.

        Bodies are drawn with a thickness of at least 1/400 of the model size, so that thin bodies are visible.
        In notebooks, scenes can be rotated if trame is installed (`pip install 'pyvista[jupyter]'`) and are
        images otherwise. Returns the object of PyVista that a notebook displays.

        Parameters
        ----------
        frame
            Number of the row, from the end if negative.
        time
            A time, instead of `frame`; the closest state is shown.
        color
            A colour, or the quantity to colour by, as in `plot_shape`.
        animate
            True for a slider over the rows.
        screenshot
            Image to write, such as `x.png`, or `x.html`, a page in which the scene can be rotated. No window is
            opened.
        movie
            Animation to write, `.gif` or `.mp4`. No window is opened. A mode vibrates.
        seconds
            Duration of the animation.
        labels
            True to show the names of joints with their forces, and of probes.
        symbols
            True to show joints, supports on the ground, springs and rods, probes, gravity, reaction forces and planes.
        view
            `xy`, `xz`, `yz` or `iso`; by default chosen from the extents of the model.
        size
            Width and height in pixels.
        scale
            Factor of deflections; by default 1, for modes chosen automatically.
        parts
            Number of sections per element.
        sides
            Number of sides of a round section.

        """
        if not 0 < seconds < np.inf:
            msg = f"seconds: found {seconds}, expected a number > 0"
            raise ValueError(msg)
        if movie is not None:
            require_frames(self)
        quantity = None if color is None or _is_colour(color) else color
        scene = Scene(self, color=quantity, scale=scale, parts=parts, sides=sides, least=MIN_THICKNESS)
        row = frame_numbers(self, frame, time)[0]
        is_hidden = screenshot is not None or movie is not None
        stage = Stage(scene, row, size=size, hidden=is_hidden, symbols=symbols)
        is_moving = animate or movie is not None
        stage.fill(view=view, paint=None if quantity else color, labels=labels, moving=is_moving)
        if screenshot is not None:
            stage.write_image(screenshot)
        if movie is not None:
            stage.write_animation(movie, seconds)
        if not is_hidden:
            return stage.open(slider=animate)
        stage.plotter.close()
        return None


class Stage:
    """A plotter of PyVista with a scene."""

    def __init__(
        self, scene: Scene, row: int, *, size: tuple[int, int], hidden: bool, symbols: bool = True
    ) -> None:
        """Create a plotter for a scene in a frame. A `hidden` plotter only writes files."""
        import pyvista as pv

        self.scene, self.row = scene, row
        self.mesh = scene.mesh(row)
        self._has_symbols = symbols
        # Decorators hide the types of PyVista's methods.
        self.plotter = cast("Any", pv.Plotter(off_screen=hidden or None, window_size=list(size)))
        self.plotter.set_background("white")
        self.plotter.enable_anti_aliasing("ssaa")
        self.plotter.enable_parallel_projection()

    def fill(self, *, view: str | None, paint: str | None, labels: bool, moving: bool) -> None:
        """Add the scene. A `moving` scene has camera and colour scale for all frames."""
        extent = self.scene.lines.path.reshape(-1, 3) if moving else np.asarray(self.mesh.points)
        self.symbols = Symbols(self.scene, extent)
        self.shown = self.symbols.meshes(self.row) if self._has_symbols else {}
        self.plotter.add_mesh(self.mesh, **self._colours(paint, moving), **LIGHT)
        for group, mesh in self.shown.items():
            look = {"color": COLOURS[group], "opacity": OPACITIES.get(group, 1.0)}
            self.plotter.add_mesh(mesh, **look, **LIGHT)
        text = frame_label(self.scene.result, self.row)
        self.title = self.plotter.add_text(text, position="upper_left", font_size=10, color="black")
        self.plotter.add_axes(color="black")
        if labels:
            self._add_labels()
        self._set_camera(view, moving)

    def _colours(self, paint: str | None, moving: bool) -> dict[str, Any]:
        """Return the colour options of the mesh."""
        if paint is not None:
            return {"color": paint}
        quantity = self.scene.quantity
        if quantity is None:
            return {"scalars": "shade", "rgb": True}
        limits = quantity.limits(quantity.values if moving else quantity.values[self.row])
        self.scene.factor, label = quantity.scaled(limits)
        self.scene.move(self.mesh, self.row)
        return {
            "scalars": self.scene.color,
            "clim": [self.scene.factor * end for end in limits],
            "cmap": colour_map(quantity.colour_map),
            "nan_color": "#b0b0b0",
            "scalar_bar_args": {"title": f"{fill(label, TITLE_WIDTH)}\n", **COLOUR_BAR},
        }

    def write_image(self, path: str | os.PathLike[str]) -> None:
        """Write an image, or a page in which the scene can be rotated."""
        if Path(path).suffix.lower() != ".html":
            self.plotter.screenshot(str(path))
        elif _has_trame():
            # PyVista 0.49 moved the functions that need trame to an attribute.
            getattr(self.plotter, "trame", self.plotter).export_html(str(path))
        else:
            msg = f"{path}: needs trame: pip install 'pyvista[jupyter]'"
            raise RuntimeError(msg)

    def write_animation(self, path: str | os.PathLike[str], seconds: float) -> None:
        """Write an animation, `.gif` or `.mp4`."""
        kind = Path(path).suffix.lower()
        needed = {".gif": ["imageio"], ".mp4": ["imageio", "imageio_ffmpeg"]}
        if kind not in needed:
            msg = f"movie: found {str(path)!r}, expected a name that ends in .gif or .mp4"
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
            self.move(row, scale)
            self.plotter.write_frame()

    def open(self, *, slider: bool) -> object:
        """Open a window. In a notebook return a scene that can be rotated, or an image without trame."""
        import pyvista as pv

        notebook = bool(self.plotter.notebook)
        is_interactive = _has_trame() and pv.global_theme.jupyter_backend not in {"static", "none"}
        if slider and (is_interactive or not notebook):
            last = len(self.scene.result.frames) - 1
            self.plotter.add_slider_widget(
                lambda value: self.move(round(value)), [0, last], value=self.row, fmt="%.0f", color="black"
            )
        return self.plotter.show(**({} if is_interactive or not notebook else {"jupyter_backend": "static"}))

    def move(self, row: int, scale: float | None = None) -> None:
        """Move the scene to another frame."""
        self.row = row
        self.scene.move(self.mesh, row, scale)
        if self.shown:
            for group, mesh in self.symbols.meshes(row, scale).items():
                # A group may be missing in the first frame, such as the arrow of a force that was zero.
                if group in self.shown:
                    self.shown[group].copy_from(mesh)
        self.title.set_text("upper_left", frame_label(self.scene.result, row))

    def _frames(self, seconds: float) -> list[tuple[int, float | None]]:
        """Return frames and factors of deflections of an animation."""
        scene = self.scene
        if scene.lines.modal:
            periods = max(1, round(seconds))
            count = max(2, round(FPS * seconds / periods))
            scale = scene.lines.scale(self.row) if scene.scale is None else scene.scale
            factors = scale * np.sin(2 * np.pi * np.arange(count) / count)
            return [(self.row, x) for x in factors.tolist()] * periods
        result = scene.result
        if result.kind != "dynamics":
            return [(row, None) for row in evenly_spaced_frames(result, max(2, round(seconds * FPS)))]
        speed = float(result.frames[-1] - result.frames[0]) / seconds
        return [(row, None) for row in frames_of_animation(result, speed, FPS)[0]]

    def _extent(self, moving: bool) -> Array:
        """Return the points that determine the camera position."""
        scene, count = self.scene, len(self.scene.result.frames)
        if scene.lines.modal or not moving:
            return np.concatenate([self.mesh.points, self._symbol_points(self.row)])
        every = range(0, count, max(1, count // MAX_EXTENT_FRAMES))
        points = [(scene.points(row), self._symbol_points(row)) for row in (*every, count - 1)]
        return np.concatenate([own for pair in points for own in pair])

    def _symbol_points(self, row: int) -> Array:
        return self.symbols.points(row) if self.shown else np.empty((0, 3))

    def _set_camera(self, view: str | None, moving: bool) -> None:
        """Set direction and distance of the camera so that all points are visible beside the colour bar."""
        if view not in {None, "iso", "xy", "xz", "yz"}:
            msg = f"view: found {view!r}, expected 'xy', 'xz', 'yz' or 'iso'"
            raise ValueError(msg)
        lines = self.scene.lines
        flat = View.of(None, lines.path if moving else lines.positions(self.row))
        camera = self.plotter.camera
        self.plotter.camera_position = view or ("iso" if flat.spatial else flat.names)
        if view is None and not flat.spatial:
            # A small rotation out of the plane shows the thickness of bodies.
            camera.azimuth, camera.elevation = 20, 15
        points = self._extent(moving)
        forward = np.asarray(camera.direction)
        right = np.cross(forward, camera.up)
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(right, forward), forward])
        low, high = (points @ axes.T).min(0), (points @ axes.T).max(0)
        half, middle = (high - low) / 2, (high + low) / 2
        width, height = self.plotter.window_size
        fill = FILL if self.scene.quantity is None else FILL_BESIDE_BAR
        scale = max(half[1] / FILL, half[0] / fill * height / width) or 1.0
        middle[0] += (FILL - fill) * scale * width / height
        camera.focal_point = middle @ axes
        camera.position = middle @ axes - forward * 4 * (scale + half[2])
        camera.parallel_scale = scale
        self.plotter.reset_camera_clipping_range()

    def _add_labels(self) -> None:
        """Add the names of joints with their forces, and of probes, at their positions."""
        named = self.symbols.labels(self.row)
        if named:
            look = {"font_size": 13, "bold": False, "text_color": "black", "shape_color": "white"}
            positions = np.array(list(named.values()))
            self.plotter.add_point_labels(
                positions, list(named), shape_opacity=0.7, always_visible=True, **look
            )


def _has_trame() -> bool:
    """Return True if scenes in notebooks can be rotated. PyVista 0.49 moved this to a package of its own."""
    import pyvista as pv

    new = tuple(int(part) for part in pv.__version__.split(".")[:2]) >= (0, 49)
    return find_spec("trame_pyvista" if new else "trame") is not None


def _is_colour(color: str) -> bool:
    """Return True for the name of a colour, False for that of a quantity."""
    import pyvista as pv

    try:
        pv.Color(color)
    except ValueError:
        return False
    return True
