"""How far a run is."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from types import TracebackType


class Bar:
    """A bar that fills as a motion goes on."""

    def __init__(self, duration: float | None, wanted: bool | None) -> None:
        """A bar for a motion of a duration, if one is wanted; if that is not said, where somebody can see it."""
        self._bar: Any = None
        self._duration = duration
        self._wanted = duration is not None and (is_seen() if wanted is None else wanted)

    def __enter__(self) -> Bar:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        if self._bar is not None:
            self._bar.close()

    @property
    def tick(self) -> Any:
        """What is to be called with the time that is reached, now and then; nothing if no bar is wanted."""
        return self._tick if self._wanted else None

    def _tick(self, time: float) -> None:
        if self._bar is None:
            # Short runs are over before the first tick, and need no bar.
            if time <= 0.0:
                return
            from tqdm.auto import tqdm

            form = "{percentage:3.0f}%|{bar}| t = {n:.4g} of {total:.4g} [{elapsed}<{remaining}]"
            self._bar = tqdm(total=self._duration, bar_format=form, leave=False)
        self._bar.update(time - self._bar.n)


def is_seen() -> bool:
    """Whether somebody can see a bar: in a terminal or a notebook."""
    return _in_notebook() or (sys.stderr is not None and sys.stderr.isatty())


def _in_notebook() -> bool:
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return type(shell).__name__ == "ZMQInteractiveShell"
