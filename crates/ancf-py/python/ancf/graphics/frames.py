"""Frames of a result: selection, labels and checks."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from ancf.display.numbers import format_number, with_unit

if TYPE_CHECKING:
    from ancf.record.result_data import ResultData

DURATION = 5.0
"""Default duration of an animation in seconds."""


def frame_numbers(
    result: ResultData, frame: int | Iterable[int] = -1, time: float | Iterable[float] | None = None
) -> list[int]:
    """Return the numbers of the frames at `frame`, from the end if negative, or closest to `time` if given."""
    if time is not None:
        times = np.atleast_1d(np.asarray(time, dtype=float))
        if not times.size or not np.isfinite(times).all():
            msg = f"time: found {time}, expected a finite number or several"
            raise ValueError(msg)
        if result.kind != "dynamics":
            msg = f"a result of {result.kind} has no time"
            raise AttributeError(msg)
        return [int(np.abs(result.frames - t).argmin()) for t in times]
    chosen = list(frame) if isinstance(frame, Iterable) else [frame]
    if not chosen or not all(isinstance(row, int | np.integer) for row in chosen):
        msg = f"frame: found {frame}, expected the number of a row or of several"
        raise ValueError(msg)
    count = len(result.frames)
    for row in chosen:
        if not -count <= row < count:
            msg = f"frame {row}: the result has {count} {'rows' if count == len(result) else 'states'}"
            raise IndexError(msg)
    return [int(row) % count for row in chosen]


def frames_of_animation(result: ResultData, speed: float | None, fps: int) -> tuple[list[int], float]:
    """Return the frames of an animation and the ratio of model time to playback time."""
    if result.kind != "dynamics":
        return evenly_spaced_frames(result, round(DURATION * fps)), 1.0
    time = result.frames
    duration = float(time[-1] - time[0])
    speed = duration / DURATION if speed is None else speed
    if not 0 < speed < np.inf:
        msg = f"speed: found {speed}, expected a number > 0, or None"
        raise ValueError(msg)
    count = max(2, round(duration / speed * fps) + 1)
    at = np.linspace(time[0], time[-1], count)
    after = np.searchsorted(time, at).clip(1, len(time) - 1)
    is_before = at - time[after - 1] < time[after] - at
    return [int(row) for row in np.where(is_before, after - 1, after)], speed


def evenly_spaced_frames(result: ResultData, count: int) -> list[int]:
    """Return `count` frames evenly spaced by number."""
    return [round(row) for row in np.linspace(0, len(result.frames) - 1, count)]


def require_frames(result: ResultData) -> None:
    """Raise an error if an animation would have fewer than two frames."""
    count = len(result.frames)
    # Without kept states, the field functions report which option is missing.
    if not result.is_modal and count < 2 and (count or not len(result)):
        msg = f"animation: found a result of {count} row{'s' * (count != 1)}, expected at least two rows"
        raise ValueError(msg)


def require_int(name: str, value: object, least: int) -> None:
    """Raise an error if a value is not an integer or is too small."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < least:
        msg = f"{name}: found {value!r}, expected an integer >= {least}"
        raise ValueError(msg)


def frame_label(result: ResultData, frame: int) -> str:
    """Return the label of a frame: time, load factor, frequency or critical load factor."""
    value, row = result.frames[frame], result.frame_rows[frame]
    if result.kind == "dynamics":
        return f"t = {with_unit(format_number(value), result.field_units.get('time'), ' ')}"
    if result.is_modal and row < 0:
        return f"{'mode' if result.kind == 'modes' else 'shape'} {format_number(value)}"
    if result.kind == "modes":
        frequency = result.frequencies[row]
        if "squared" in result.columns and result["squared"][row] < 0:
            return f"mode {row + 1}: unstable"
        unit = result.units.get("frequency")
        unit = "Hz" if unit == "1/s" else unit
        return f"mode {row + 1}: f = {with_unit(format_number(frequency), unit, ' ')}"
    if result.kind == "buckling":
        return f"shape {row + 1}: factor {format_number(result.factors[row])}"
    return f"load factor {format_number(value)}"


def elastic_modes(result: ResultData) -> list[int]:
    """Return the frames of the modes that are not rigid-body modes, or all frames if there are no others."""
    every = list(range(len(result.frames)))
    if result.kind == "buckling":
        return every
    rows = result.frame_rows
    elastic = [frame for frame in every if rows[frame] < 0 or result.frequencies[rows[frame]] != 0]
    return elastic or every
